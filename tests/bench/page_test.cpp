// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/page.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace oplus {
namespace {

Report report_with_two_engines() {
  const auto done = [](const std::string& engine, const std::string& digest,
                       const std::string& area) {
    return Measurement{.engine = engine,
                       .digest = digest,
                       .area = area,
                       .numbers = {{"seconds", 0.5}, {"peak_mb", 1}, {"sum_holes", 0}}};
  };
  const Measurement crashed{
      .engine = "cgal-full", .outcome = Measurement::Ending::crashed, .note = "signal 11"};
  return {.setting = {.processor = "a processor", .cores = 2, .limit = 60, .missing = {"fork"}},
          .rows = {{.name = "row",
                    .what = "two squares",
                    .measurements = {done("slide", "a", "2"), done("rca", "b", "2"),
                                     done("clipper", "", "3"), crashed}}}};
}

std::string page(const std::string& text) {
  return rendered_text(text, benchmarks_data(report_with_two_engines()));
}

TEST(Page, replaces_names) {
  EXPECT_EQ(page("on {{processor}}, {{cores}} cores."), "on a processor, 2 cores.");
}

TEST(Page, refuses_unknown_names_and_invalid_templates) {
  EXPECT_THROW(page("{{nothing}}"), std::invalid_argument);
  EXPECT_THROW(page("{{#nothing}}{{/nothing}}"), std::invalid_argument);
  EXPECT_THROW(page("{{>nothing}}"), std::invalid_argument);
  EXPECT_THROW(page("{{#rows}}"), std::invalid_argument);
  EXPECT_THROW(rendered("nothing", {}), std::invalid_argument);
}

TEST(Page, escapes_nothing) { EXPECT_EQ(rendered_text("{{x}}", PageData("x", "<&\">")), "<&\">"); }

TEST(Page, names_what_went_wrong) {
  EXPECT_EQ(page("{{equal}} of {{compared}}"), "0 of 1");
  EXPECT_EQ(page("{{#remarks}}\n- {{.}}.\n{{/remarks}}\n"),
            "- two squares: **slide against rca disagree**.\n"
            "- two squares: cgal-full crashed: signal 11.\n"
            "- The published pair fork is missing.\n");
}

TEST(Page, shows_tables) {
  EXPECT_EQ(
      page("{{#sums}}\nsum, ms = what\nholes = sum_holes\n* = 1000 *.seconds\n{{/sums}}\nend\n"),
      "| sum, ms | holes | slide | rca | cgal-full | clipper |\n"
      "|---|---|---|---|---|---|\n"
      "| two squares | 0 | 500 | 500 | crashed: signal 11 | 500 |\n"
      "end\n");
}

TEST(Page, shows_rounding_errors_and_the_exact_result) {
  const std::string errors = page(
      "{{#rounding_engines}}\nsum = what\n* = e *.area_error; relative = e *.relative_area_error\n"
      "{{/rounding_engines}}\n");
  EXPECT_NE(errors.find("| two squares | 1.0e+00 | 5.0e-01 |"), std::string::npos) << errors;
}

TEST(Page, has_every_name_of_its_template) {
  const std::string of_run =
      rendered("benchmarks.md.mustache", benchmarks_data(report_with_two_engines()));
  EXPECT_EQ(of_run.find("{{"), std::string::npos);
  EXPECT_EQ(of_run.find("\n\n\n"), std::string::npos);
  EXPECT_NE(rendered("benchmarks.md.mustache", benchmarks_data({})), "");
}

}  // namespace
}  // namespace oplus
