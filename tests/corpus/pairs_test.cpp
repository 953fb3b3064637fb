// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <cctype>
#include <set>

#include "checked/arrangement/hole_test.hpp"
#include "checked/engines/engines.hpp"
#include "checked/operations/set_sum.hpp"
#include "checked/operations/union_of.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/compare/corpus.hpp"
#include "properties/runner/source_tree.hpp"
#include "properties/statements/placements/sets_meet.hpp"
#include "reference/io/file_text.hpp"
#include "reference/oracle/cell_sets.hpp"
#include "reference/oracle/oracle.hpp"
#include "reference/oracle/set_by_pieces.hpp"
#include "tests/checked/cli/page_text.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

/// The name and the story of each row, of regions and of other sets.
std::vector<std::pair<std::string, std::string>> stories() {
  std::vector<std::pair<std::string, std::string>> result;
  for (const CorpusPair& row : corpus()) result.emplace_back(row.name, row.story);
  for (const CorpusSets& row : corpus_of_sets()) result.emplace_back(row.name, row.story);
  return result;
}

TEST(Corpus, rows_have_distinct_names_and_stories) {
  std::set<std::string> names;
  for (const auto& [name, story] : stories()) {
    EXPECT_TRUE(names.insert(name).second) << name << " occurs twice";
    for (const char c : name) EXPECT_TRUE(std::islower(c) || std::isdigit(c) || c == '_') << name;
    EXPECT_TRUE(story.ends_with('.')) << name << ": no full stop";
  }
  EXPECT_TRUE(names.contains("cgal_full_convolution_crash"));
  EXPECT_TRUE(names.contains("touching_diamond_hole_twice"));
}

TEST(Corpus, each_row_is_of_regions_or_of_other_sets) {
  const std::string text = text_of_file(source_root() / "tests/corpus/pairs.txt");
  std::set<std::string> of_sets;
  for (const CorpusSets& row : corpus_of_sets()) of_sets.insert(row.name);
  EXPECT_EQ(corpus().size() + of_sets.size(), found(text, "\n(name): ").size());
  EXPECT_EQ(of_sets,
            (std::set<std::string>{"cgal_segment_and_polygon", "clipper_open_path_and_pattern",
                                   "clipper_filled_pattern_and_open_path"}));
}

/// A section of docs/findings.md, or a line of its tables, names the row and each version (6.1.1) or
/// statement (4.1.9) of its story.
TEST(Corpus, findings_have_each_row_whose_story_names_a_version_or_statement) {
  std::string page = text_of_file(source_root() / "docs/findings.md");
  for (const std::string begin : {"\n### ", "\n| "}) boost::replace_all(page, begin, "\n## ");
  std::vector<std::string> sections;
  boost::iter_split(sections, page, boost::first_finder("\n## "));
  std::size_t told = 0;
  for (const auto& [name, story] : stories()) {
    for (const std::string& number : found(story, "(\\d+(?:\\.\\d+)+)")) {
      ++told;
      EXPECT_TRUE(std::ranges::any_of(sections,
                                      [&, row = name](const std::string& section) {
                                        return boost::contains(section, '`' + row + '`') &&
                                               boost::contains(section, number);
                                      }))
          << "docs/findings.md lacks " << name << ' ' << number;
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

SetByPieces set_by_pieces(const ReadSet& set) {
  return {edges(set.region), set.segments, set.points};
}

ClaimedSum parts(const ReadSet& set) { return {set.region, set.segments, set.points}; }

PlanarSet sum_by_definition(const ReadSet& p, const ReadSet& q, Boundary boundary) {
  return set_where(
      vertex_edge_sum(set_by_pieces(p), set_by_pieces(q)), boundary, [&](const Point& x) {
        if (boundary == Boundary::closed)
          return meet(translated(reflected(set_by_pieces(q)), x), set_by_pieces(p));
        const ClaimedSum placed = reflected_to(x, parts(q));
        return interior_meets(p.region, placed) || interior_meets(placed.region, parts(p));
      });
}

TEST(Corpus, sums_of_sets_are_those_of_the_definition) {
  for (const CorpusSets& row : corpus_of_sets()) {
    for (const auto& [boundary, expected] :
         {std::pair(Boundary::closed, row.closed), std::pair(Boundary::open, row.open)}) {
      EXPECT_EQ(sum_by_definition(row.p, row.q, boundary), expected) << row.name;
      const auto value = [](const ReadSet& set) {
        return union_of(set.region, set.segments, set.points);
      };
      EXPECT_EQ(set_sum(value(row.p), value(row.q), boundary, by_slide), expected) << row.name;
      EXPECT_EQ(set_sum(value(row.q), value(row.p), boundary, by_slide), expected)
          << row.name << ", swapped";
    }
  }
}

TEST(Corpus, every_engine_gives_the_sums_of_every_row) {
  const auto same = [](const Region& p, const Region& q, const CorpusPair& row,
                       const std::string& how) {
    for (const Engine& engine : engines()) {
      for (const auto& [name, method] : hole_test_methods()) {
        const auto sum = [&, hole_test = method](Boundary boundary) {
          return engine.compute(p, q, boundary, {.hole_test = hole_test}).sum;
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
