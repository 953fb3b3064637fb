// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <sstream>

#include "properties/compare/counterexample_files.hpp"
#include "properties/compare/report_json.hpp"
#include "properties/compare/report_text.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"
#include "tests/checked/cli/shell.hpp"
#include "tests/properties/compare/faulty_engines.hpp"

namespace oplus {
namespace {

/// Several kinds at once, with words that Markdown and XML must not take for their own.
const CampaignReport& report_of_many_kinds() {
  static const CampaignReport report =
      SmallRun{.parts = {"grids"}, .cases = 40, .shrink_tries = 20}.of(
          of_many_kinds("a|b <c> & \"d\""));
  return report;
}

class ReportFiles : public Shell {};

TEST_F(ReportFiles, are_valid) {
  const CampaignReport& report = report_of_many_kinds();
  EXPECT_GE(report.all().kinds.size(), 3U);
  put("r.json", report_text(report, "r.json"));
  put("r.xml", report_text(report, "r.xml"));
  const Ran ran =
      run("python3 -c 'import json, xml.etree.ElementTree as tree\n"
          "all = json.load(open(\"r.json\"))\n"
          "root = tree.parse(\"r.xml\").getroot()\n"
          "cases = list(root.iter(\"testcase\"))\n"
          "assert len(cases) == int(root.get(\"tests\")) == len(all[\"sources\"])\n"
          "assert len(list(root.iter(\"failure\"))) == int(root.get(\"failures\"))\n"
          "assert root.get(\"name\").endswith(all[\"campaign\"][\"engines\"][0])\n"
          "print(sorted(all[\"counterexamples\"]))'",
          0);
  EXPECT_TRUE(has(ran.out, "isolated vertex invented"));
}

TEST_F(ReportFiles, junit_gives_each_case_its_own_pair) {
  const CampaignReport& report = report_of_many_kinds();
  const std::string xml = to_junit(report);
  std::set<std::size_t> first_pairs;
  for (const CountedSource& source : report.sources) {
    const std::size_t start = xml.find(" name=\"" + source.name + '"');
    ASSERT_NE(start, std::string::npos) << source.name;
    const std::string own = xml.substr(start, xml.find("</testcase>", start) - start);
    EXPECT_EQ(source.first_failures.size(), source.counts.kinds.size());
    for (const auto& [kind, first] : source.first_failures) {
      EXPECT_TRUE(has(own, "first found in " + first.found_in));
      EXPECT_TRUE(has(own, "P " + wkt(first.pair.p) + "\nQ " + wkt(first.pair.q)));
      first_pairs.insert(first.index);
    }
  }
  EXPECT_GE(first_pairs.size(), report.sources.size());
}

TEST_F(ReportFiles, tables_have_as_many_cells_in_each_row) {
  std::istringstream in(to_markdown(report_of_many_kinds()));
  std::size_t expected = 0, rows = 0;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with('|')) {
      expected = 0;
      continue;
    }
    std::size_t bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
      bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
    if (expected == 0) expected = bars;
    EXPECT_EQ(bars, expected) << line;
    ++rows;
  }
  EXPECT_GT(rows, 10U);
}

TEST_F(ReportFiles, counterexamples_are_written_and_read_again) {
  const CampaignReport& report = report_of_many_kinds();
  CampaignReport moved = report;
  moved.out = (folder() / "found").string();
  write_counterexamples(moved);
  for (const auto& [kind, shrunk] : report.counterexamples) {
    const CounterexampleFiles files = files_of(shrunk);
    EXPECT_EQ(read_region_file((folder() / "found" / files.p).string()).region, shrunk.sum.pair.p);
    EXPECT_EQ(read_region_file((folder() / "found" / files.q).string()).region, shrunk.sum.pair.q);
    if (shrunk.sum.right) {
      EXPECT_EQ(read_sum_file((folder() / "found" / files.right).string()).sum, *shrunk.sum.right);
    }
    EXPECT_TRUE(content("found/" + files.picture).starts_with("<svg")) << kind;
  }
}

TEST(Explanation, says_how_they_differ_and_how_to_reproduce_it) {
  CampaignReport report = report_of_many_kinds();
  report.out = "folder";
  const ShrunkFailure& found = report.counterexamples.at("isolated vertex invented");
  const std::string text = explanation(report, found);
  for (const char* part :
       {"the first is the oracle: 1 outer chain, 0 holes, 0 dangling edges, 0 isolated",
        "the second is a|b <c> & \"d\": 1 outer chain, 0 holes, 0 dangling edges, 1 iso",
        "they differ at (1000, 1000)"})
    EXPECT_TRUE(has(text, part));
  const CounterexampleFiles files = files_of(found);
  EXPECT_TRUE(has(text, "picture: folder/" + files.picture));
  EXPECT_TRUE(has(text, "--engine 'a|b <c> & \"d\"' --pair folder/" + files.p + " folder/"));
}

TEST(Report, says_who_judged) {
  CampaignReport report = report_of_many_kinds();
  report.campaign.judge = "convex-parts";
  const std::string who = "the sum of convex parts";
  EXPECT_TRUE(has(summary(report), "compared with " + who + ":\n"));
  EXPECT_TRUE(has(to_markdown(report), "Compared with " + who + "."));
  EXPECT_TRUE(has(sealed(report), R"("judge": "convex-parts")"));
  const ShrunkFailure& found = report.counterexamples.at("isolated vertex invented");
  EXPECT_TRUE(has(explanation(report, found), "the first is " + who + ": 1 outer chain"));
  EXPECT_TRUE(has(replay_line(report, found), " --judge convex-parts "));
}

TEST(ReportJson, sees_what_was_changed) {
  const std::string text = sealed(report_of_many_kinds());
  EXPECT_NO_THROW(opened(text, "r.json"));
  for (const std::string& wrong :
       {text.substr(0, text.size() / 2), std::string(), std::string("[]"), std::string("{}")})
    EXPECT_THROW(opened(wrong, "r.json"), InvalidInput) << wrong;
  std::string changed = text;
  char& digit = changed[changed.find("\"pairs\": ") + 9];
  digit = digit == '2' ? '3' : '2';
  EXPECT_THROW(opened(changed, "r.json"), InvalidInput);
  // With a right checksum it may still be inconsistent.
  CampaignReport odd = report_of_many_kinds();
  odd.done = odd.pairs + 1;
  EXPECT_THROW(opened(sealed(odd), "r.json"), InvalidInput);
  CampaignReport unknown = report_of_many_kinds();
  unknown.campaign.judge = "nobody";
  unknown.counterexamples.clear();  // their lines to reproduce them name the judge
  EXPECT_THROW(opened(sealed(unknown), "r.json"), InvalidInput);
}

}  // namespace
}  // namespace oplus
