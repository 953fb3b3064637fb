// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/conformance/report.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "properties/compare/sealed_report.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/reading.hpp"
#include "tests/checked/cli/shell.hpp"
#include "tests/properties/compare/conformance/faulty_implementations.hpp"

namespace oplus {
namespace {

/// Several kinds at once, with words that Markdown and XML must not take for their own.
ConformanceReport report_of_many_kinds() {
  Engine faulty = named_engine(
      "a|b <c> & \"d\"", [](const Region& p, const Region& q, Boundary boundary) -> MinkowskiSum {
        MinkowskiSum sum = slide_sum(p, q, boundary).sum;
        if (vertex_count(p) == 5) throw NoSum(NoSum::Kind::crashed, "x < y && z|w", "it <died>\n");
        if (vertex_count(p) == 6) std::swap(sum.outer[0][0], sum.outer[0][1]);
        if (vertex_count(q) == 4) sum.isolated_vertices.push_back({1000, 1000});
        return sum;
      });
  ConformanceSettings settings = few({"grids"});
  settings.cases = 40;
  settings.shrink_tries = 20;  // a report does not depend on it
  return conformance_of(faulty, settings);
}

class ConformanceReportFiles : public Shell {};

TEST_F(ConformanceReportFiles, are_valid) {
  const ConformanceReport report = report_of_many_kinds();
  EXPECT_GE(report.all().kinds.size(), 3U);
  put("r.json", conformance_text(report, "r.json"));
  put("r.xml", conformance_text(report, "r.xml"));
  const Ran ran =
      run("python3 -c 'import json, xml.etree.ElementTree as tree\n"
          "all = json.load(open(\"r.json\"))\n"
          "root = tree.parse(\"r.xml\").getroot()\n"
          "cases = list(root.iter(\"testcase\"))\n"
          "assert len(cases) == int(root.get(\"tests\")) == len(all[\"groups\"])\n"
          "assert len(list(root.iter(\"failure\"))) == int(root.get(\"failures\"))\n"
          "assert root.get(\"name\").endswith(all[\"campaign\"][\"engine\"])\n"
          "print(sorted(c[\"kind\"] for c in all[\"counterexamples\"]))'");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_NE(ran.out.find("isolated vertex invented"), std::string::npos) << ran.out;
}

TEST_F(ConformanceReportFiles, tables_have_as_many_cells_in_each_row) {
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

TEST_F(ConformanceReportFiles, counterexamples_are_written_and_read_again) {
  const ConformanceReport report = report_of_many_kinds();
  const std::string here = run("pwd").out;
  const std::filesystem::path folder =
      std::filesystem::path(here.substr(0, here.size() - 1)) / "found";
  write_counterexamples(report, folder.string());
  for (const auto& [kind, shrunk] : report.counterexamples) {
    const CounterexampleFiles files = files_of(shrunk);
    EXPECT_EQ(read_region_file((folder / files.p).string()).region, shrunk.seen.summands.p);
    EXPECT_EQ(read_region_file((folder / files.q).string()).region, shrunk.seen.summands.q);
    if (shrunk.seen.right) {
      EXPECT_EQ(read_sum_file((folder / files.right).string()).sum, *shrunk.seen.right);
    }
    EXPECT_TRUE(content("found/" + files.picture).starts_with("<svg")) << kind;
  }
}

TEST(ConformanceReport, survives_json) {
  const ConformanceReport report = report_of_many_kinds();
  const std::string text = sealed(to_json(report));
  const ConformanceReport read = conformance_of_json(opened(text, "r.json"));
  EXPECT_EQ(sealed(to_json(read)), text);
  EXPECT_EQ(to_markdown(read), to_markdown(report));
  EXPECT_EQ(to_junit(read), to_junit(report));
}

TEST(SealedReport, sees_what_was_changed) {
  const std::string text = sealed(to_json(report_of_many_kinds()));
  EXPECT_NO_THROW(opened(text, "r.json"));
  EXPECT_THROW(opened(text.substr(0, text.size() / 2), "r.json"), InvalidInput);
  EXPECT_THROW(opened("", "r.json"), InvalidInput);
  EXPECT_THROW(opened("[]", "r.json"), InvalidInput);
  EXPECT_THROW(opened("{}", "r.json"), InvalidInput);
  std::string changed = text;
  char& digit = changed[changed.find("\"pairs\": ") + 9];
  digit = digit == '2' ? '3' : '2';
  EXPECT_THROW(opened(changed, "r.json"), InvalidInput);
}

}  // namespace
}  // namespace oplus
