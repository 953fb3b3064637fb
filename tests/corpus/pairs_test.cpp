// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cctype>
#include <set>

#include "checked/arrangement/hole_test.hpp"
#include "checked/engines/engines.hpp"
#include "properties/compare/corpus.hpp"
#include "properties/runner/source_tree.hpp"
#include "reference/io/file_text.hpp"
#include "reference/oracle/oracle.hpp"
#include "tests/checked/cli/page_text.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

TEST(Corpus, rows_have_distinct_names_and_stories) {
  const std::vector<CorpusPair> rows = corpus();
  std::set<std::string> names;
  for (const CorpusPair& row : rows) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " occurs twice";
    for (const char c : row.name)
      EXPECT_TRUE(std::islower(c) || std::isdigit(c) || c == '_') << row.name;
    EXPECT_TRUE(row.story.ends_with('.')) << row.name << ": no full stop";
  }
  EXPECT_TRUE(names.contains("cgal_full_convolution_crash"));
  EXPECT_TRUE(names.contains("touching_diamond_hole_twice"));
}

/// A section of docs/findings.md, or a line of its tables, names the row and each version (6.1.1) or
/// statement (4.1.9) of its story.
TEST(Corpus, findings_have_each_row_whose_story_names_a_version_or_statement) {
  std::string page = text_of_file(source_root() / "docs/findings.md");
  for (const std::string begin : {"\n### ", "\n| "}) boost::replace_all(page, begin, "\n## ");
  std::vector<std::string> sections;
  boost::iter_split(sections, page, boost::first_finder("\n## "));
  std::size_t told = 0;
  for (const CorpusPair& row : corpus()) {
    for (const std::string& number : found(row.story, "(\\d+(?:\\.\\d+)+)")) {
      ++told;
      EXPECT_TRUE(std::ranges::any_of(sections,
                                      [&](const std::string& section) {
                                        return boost::contains(section, '`' + row.name + '`') &&
                                               boost::contains(section, number);
                                      }))
          << "docs/findings.md lacks " << row.name << ' ' << number;
    }
  }
  EXPECT_GT(told, 12U);
}

TEST(Corpus, oracle_gives_the_sums_of_every_row) {
  for (const CorpusPair& row : corpus()) {
    const OracleSums sums = oracle_sums(row.p, row.q);
    EXPECT_EQ(sums.closed, row.closed) << row.name;
    EXPECT_EQ(sums.open, row.open) << row.name;
    const OracleSums swapped = oracle_sums(row.q, row.p);
    EXPECT_EQ(swapped.closed, row.closed) << row.name << ", swapped";
    EXPECT_EQ(swapped.open, row.open) << row.name << ", swapped";
  }
}

TEST(Corpus, every_engine_gives_the_sums_of_every_row) {
  const auto same = [](const Region& p, const Region& q, const CorpusPair& row,
                       const std::string& how) {
    for (const Engine& engine : engines()) {
      for (const auto& [name, method] : hole_test_methods()) {
        const auto sum = [&](Boundary boundary) {
          return engine.compute(p, q, boundary, {.hole_test = method}).sum;
        };
        EXPECT_EQ(sum(Boundary::closed), row.closed) << engine.name << ", " << name << how;
        EXPECT_EQ(sum(Boundary::open), row.open) << engine.name << ", " << name << how;
        if (!engine.has_hole_test) break;
      }
    }
  };
  for (const CorpusPair& row : corpus()) {
    same(row.p, row.q, row, ", " + row.name);
    same(row.q, row.p, row, ", " + row.name + ", swapped");
  }
}

}  // namespace
}  // namespace oplus
