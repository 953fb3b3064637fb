// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/page.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace oplus {
namespace {

Report report_with_two_engines() {
  Report report;
  report.setting = {"a processor", 2, "a compiler", "libraries", "oplus-bench", 60, {"fork"}};
  RowReport row;
  row.name = "row";
  row.what = "two squares";
  for (const auto& [engine, digest, area] :
       {std::tuple("slide", "a", "2"), std::tuple("rca", "b", "2"),
        std::tuple("clipper", "", "3")}) {
    Measurement m;
    m.engine = engine;
    m.digest = digest;
    m.area = area;
    m.seconds = 0.5;
    m.peak_mb = 1;
    row.measurements.push_back(m);
  }
  Measurement crashed;
  crashed.engine = "cgal-full";
  crashed.outcome = Outcome::crashed;
  crashed.note = "signal 11";
  row.measurements.push_back(crashed);
  report.rows = {row};
  return report;
}

std::string page(const std::string& page_template) {
  return page_of(report_with_two_engines(), page_template);
}

TEST(Page, replaces_its_marks) { EXPECT_EQ(page("on @MACHINE@."), "on a processor, 2 cores."); }

TEST(Page, refuses_marks_it_does_not_know) {
  EXPECT_THROW(page("@NOTHING@"), std::invalid_argument);
  EXPECT_THROW(page("an @ alone"), std::invalid_argument);
}

TEST(Page, says_what_went_wrong) {
  EXPECT_EQ(page("@AGREEMENT@"),
            "On 0 of 1 rows with two exact engines or more, all exact results are equal");
  EXPECT_EQ(page("@REMARKS@"),
            "- two squares: **slide against rca disagree**.\n"
            "- two squares: cgal-full crashed: signal 11.\n"
            "- The published pair fork was not there.\n");
}

TEST(Page, shows_errors_of_rounding_beside_the_exact_result) {
  EXPECT_NE(page("@ERRORS@").find("| two squares | 0 | 1.0e+00 | 5.0e-01 | 0 |"), std::string::npos)
      << page("@ERRORS@");
}

TEST(Page, knows_every_mark_of_its_template) {
  std::ifstream file(OPLUS_BENCH_PAGE);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(text.empty());
  EXPECT_EQ(page(text).find('@'), std::string::npos);
  EXPECT_EQ(page_of({}, text).find('@'), std::string::npos);
}

}  // namespace
}  // namespace oplus
