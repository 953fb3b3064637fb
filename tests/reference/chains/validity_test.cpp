// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/validity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/reference/chains/defects_of_all_pairs.hpp"
#include "tests/reference/chains/random_regions.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Chain big = box(0, 0, 8, 8);

struct Invalid {
  std::string name;
  DefectKind kind;
  VertexIndex first;
  VertexIndex second;
  Region region;
};

VertexIndex at(std::size_t chain, std::size_t vertex) { return {chain, vertex}; }

/// Each has one kind of defect only. Where several pairs of edges show it, any may be named.
std::vector<Invalid> invalid_regions() {
  using enum DefectKind;
  const auto with_big = [](const Chain& other) { return together({polygon(big), polygon(other)}); };
  return {
      {"two vertices", too_few_vertices, at(0, 0), at(0, 0), polygon({{0, 0}, {1, 0}})},
      {"empty hole", too_few_vertices, at(1, 0), at(1, 0), holed(big, {Chain{}})},
      {"vertex twice in a row", zero_length_edge, at(0, 1), at(0, 2),
       polygon({{0, 0}, {2, 0}, {2, 0}, {0, 2}})},
      {"last vertex equal to the first", zero_length_edge, at(0, 3), at(0, 0),
       polygon({{0, 0}, {2, 0}, {0, 2}, {0, 0}})},
      {"two loops in one vertex", repeated_vertex, at(0, 0), at(0, 3),
       polygon({{2, 2}, {0, 1}, {0, 0}, {2, 2}, {3, 0}, {3, 3}})},
      {"bow tie", self_crossing, at(0, 0), at(0, 2), polygon({{0, 2}, {4, 0}, {4, 4}, {0, 0}})},
      {"flat triangle", self_overlap, at(0, 0), at(0, 2), polygon({{0, 0}, {1, 0}, {2, 0}})},
      {"vertex inside an edge", self_touching, at(0, 0), at(0, 2),
       polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})},
      {"hole through the outer chain", chains_cross, at(0, 1), at(1, 0),
       holed(big, {box(6, 2, 10, 4)})},
      {"components that cross", chains_cross, at(0, 1), at(1, 0), with_big(box(6, 6, 10, 10))},
      {"through a vertex", chains_cross, at(0, 1), at(1, 0), with_big({{6, 8}, {8, 6}, {10, 10}})},
      {"in and out through common vertices", chains_cross, at(0, 0), at(1, 0),
       together({polygon({{0, 0}, {4, 4}, {0, 8}, {0, 4}}),
                 polygon({{0, 4}, {2, 3}, {4, 4}, {4, 10}, {-4, 10}})})},
      {"hole along the outer chain", chains_overlap, at(0, 3), at(1, 2),
       holed(big, {box(0, 2, 4, 4)})},
      {"equal components", chains_overlap, at(0, 0), at(1, 0), with_big(big)},
      {"hole beside", hole_outside, at(1, 0), at(0, 0), holed(big, {box(10, 0, 12, 2)})},
      {"hole around", hole_outside, at(1, 0), at(0, 0), holed(box(2, 2, 4, 4), {big})},
      {"hole touching from outside", hole_outside, at(1, 0), at(0, 0),
       holed(big, {{{8, 4}, {9, 3}, {9, 5}}})},
      {"hole in a hole", holes_nested, at(2, 0), at(1, 0),
       holed(big, {box(1, 1, 7, 7), box(2, 2, 3, 3)})},
      {"component in a component", components_overlap, at(1, 0), at(0, 0),
       with_big(box(2, 2, 3, 3))},
      {"component around another's hole", components_overlap, at(2, 0), at(0, 0),
       together({holed(big, {box(3, 3, 4, 4)}), polygon(box(2, 2, 5, 5))})},
      {"component in a component, touching it in two vertices", components_overlap, at(1, 0),
       at(0, 0), with_big({{0, 0}, {4, 1}, {8, 8}, {1, 4}})},
  };
}

TEST(Validity, names_the_defect) {
  for (const Invalid& invalid : invalid_regions()) {
    const auto defect = find_defect(invalid.region);
    ASSERT_TRUE(defect) << invalid.name;
    EXPECT_EQ(describe(defect->kind), describe(invalid.kind)) << invalid.name;
    const auto chain_pair = [](const VertexIndex& a, const VertexIndex& b) {
      return std::minmax({a.chain, b.chain});
    };
    EXPECT_EQ(chain_pair(defect->first, defect->second), chain_pair(invalid.first, invalid.second))
        << invalid.name;
  }
}

TEST(Validity, of_vertices_names_just_these) {
  for (const Invalid& invalid : invalid_regions()) {
    if (invalid.kind > DefectKind::repeated_vertex) continue;
    const auto defect = find_defect(invalid.region);
    ASSERT_TRUE(defect) << invalid.name;
    EXPECT_TRUE(defect->first == invalid.first) << invalid.name;
    EXPECT_TRUE(defect->second == invalid.second) << invalid.name;
    const std::vector<Chain> all = chains(invalid.region);
    const Chain& chain = all[defect->first.chain];
    if (!chain.empty()) {
      EXPECT_EQ(defect->where, chain[defect->first.vertex]) << invalid.name;
    }
  }
}

TEST(Validity, every_kind_of_defect_has_a_case_and_words_of_its_own) {
  std::set<DefectKind> kinds;
  std::set<std::string> words;
  for (const Invalid& invalid : invalid_regions()) {
    kinds.insert(invalid.kind);
    words.insert(describe(invalid.kind));
  }
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(DefectKind::components_overlap) + 1);
  EXPECT_EQ(words.size(), kinds.size());
  EXPECT_FALSE(words.contains(""));
}

TEST(Validity, of_what_touches_in_points_is_not_in_doubt) {
  const std::vector<Shape> valid{
      {"empty", {}},
      {"two components touching in an edge's middle",
       together({polygon(big), polygon({{8, 4}, {9, 3}, {9, 5}})})},
      {"three holes touching in one point", holed(big, {{{4, 4}, {5, 3}, {5, 5}},
                                                        {{4, 4}, {3, 5}, {3, 3}},
                                                        {{4, 4}, {4, 6}, {Rational(7, 2), 6}}})},
      {"component that fills a hole but for touching points",
       together({holed(big, {box(2, 2, 6, 6)}), polygon({{4, 2}, {6, 4}, {4, 6}, {2, 4}})})},
      {"island in the hole of an island",
       together({holed(box(0, 0, 9, 9), {box(1, 1, 8, 8)}),
                 holed(box(2, 2, 7, 7), {box(3, 3, 6, 6)}), polygon(box(4, 4, 5, 5))})},
      {"the island before what is around it",
       together({polygon(box(2, 2, 3, 3)), holed(box(0, 0, 5, 5), {box(1, 1, 4, 4)})})},
  };
  for (const Shape& shape : valid) EXPECT_FALSE(find_defect(shape.region)) << shape.name;
  for (const Shape& shape : shapes()) EXPECT_FALSE(find_defect(shape.region)) << shape.name;
}

TEST(Validity, sees_a_crossing_by_less_than_a_double_can_hold) {
  const Rational tiny = 1 / Rational("1" + std::string(400, '0'));
  const Chain outside{{8, 4}, {9, 3}, {9, 5}};
  const auto defect_beside = [](const Chain& other) {
    return find_defect(together({polygon(big), polygon(other)}));
  };
  EXPECT_FALSE(defect_beside(outside));
  EXPECT_FALSE(defect_beside(translated(outside, {tiny, 0})));
  const auto defect = defect_beside(translated(outside, {-tiny, 0}));
  ASSERT_TRUE(defect);
  EXPECT_EQ(defect->kind, DefectKind::chains_cross);
}

std::string text(const Region& region) {
  std::string result;
  for (const Component& component : region.components)
    result += testing::PrintToString(component.outer) + " without " +
              testing::PrintToString(component.holes) + "\n";
  return result;
}

TEST(Validity, of_random_regions_is_what_all_pairs_show) {
  Random random(22);
  std::map<std::optional<DefectKind>, int> seen;
  for (int i = 0; i < 6000; ++i) {
    const Region region = random_region(random);
    const DefectsOfAllPairs expected(region);
    const std::optional<Defect> found = find_defect(region);
    ASSERT_EQ(found.has_value(), !expected.empty()) << text(region);
    ++seen[found ? std::optional(found->kind) : std::nullopt];
    if (!found) continue;
    const DefectsOfAllPairs::Named named{found->kind, found->first.chain, found->second.chain};
    const std::string wrong = describe(found->kind) + "\n" + text(region);
    if (!expected.of_vertices.empty()) {
      ASSERT_TRUE(expected.of_vertices.contains(named)) << wrong;
    } else if (!expected.of_edges.empty()) {
      ASSERT_EQ(found->where, expected.of_edges.begin()->first) << wrong;
      ASSERT_TRUE(expected.of_edges.contains({found->where, named})) << wrong;
      const std::vector<Chain> all = chains(region);
      for (const VertexIndex& at : {found->first, found->second})
        ASSERT_TRUE(lies_on(found->where, edges(all[at.chain])[at.vertex])) << wrong;
    } else {
      ASSERT_TRUE(expected.of_nesting.contains(named)) << wrong;
    }
  }
  EXPECT_GE(seen[std::nullopt], 500) << "valid";
  for (int kind = 1; kind <= static_cast<int>(DefectKind::components_overlap); ++kind)
    EXPECT_GE(seen[static_cast<DefectKind>(kind)], 5) << describe(static_cast<DefectKind>(kind));
}

}  // namespace
}  // namespace oplus
