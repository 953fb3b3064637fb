// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/validity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Chain big = box(0, 0, 8, 8);

struct Invalid {
  std::string name;
  Region region;
  DefectKind kind;
  VertexIndex first;
  VertexIndex second;
};

/// Each has one kind of defect only. Where several pairs of edges show it, any may be named.
std::vector<Invalid> invalid_regions() {
  using enum DefectKind;
  return {
      {"two vertices", polygon({{0, 0}, {1, 0}}), too_few_vertices, {0, 0}, {0, 0}},
      {"empty hole", {{{big, {{}}}}}, too_few_vertices, {1, 0}, {1, 0}},
      {"vertex twice in a row",
       polygon({{0, 0}, {2, 0}, {2, 0}, {0, 2}}),
       zero_length_edge,
       {0, 1},
       {0, 2}},
      {"last vertex equal to the first",
       polygon({{0, 0}, {2, 0}, {0, 2}, {0, 0}}),
       zero_length_edge,
       {0, 3},
       {0, 0}},
      {"two loops in one vertex",
       polygon({{2, 2}, {0, 1}, {0, 0}, {2, 2}, {3, 0}, {3, 3}}),
       repeated_vertex,
       {0, 0},
       {0, 3}},
      {"bow tie", polygon({{0, 2}, {4, 0}, {4, 4}, {0, 0}}), self_crossing, {0, 0}, {0, 2}},
      {"flat triangle", polygon({{0, 0}, {1, 0}, {2, 0}}), self_overlap, {0, 0}, {0, 2}},
      {"vertex inside an edge",
       polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}),
       self_touching,
       {0, 0},
       {0, 2}},
      {"hole through the outer chain",
       {{{big, {backwards(box(6, 2, 10, 4))}}}},
       chains_cross,
       {0, 1},
       {1, 0}},
      {"components that cross",
       {{{big, {}}, {box(6, 6, 10, 10), {}}}},
       chains_cross,
       {0, 1},
       {1, 0}},
      {"through a vertex",
       {{{big, {}}, {{{6, 8}, {8, 6}, {10, 10}}, {}}}},
       chains_cross,
       {0, 1},
       {1, 0}},
      {"in and out through common vertices",
       {{{{{0, 0}, {4, 4}, {0, 8}, {0, 4}}, {}},
         {{{0, 4}, {2, 3}, {4, 4}, {4, 10}, {-4, 10}}, {}}}},
       chains_cross,
       {0, 0},
       {1, 0}},
      {"hole along the outer chain",
       {{{big, {backwards(box(0, 2, 4, 4))}}}},
       chains_overlap,
       {0, 3},
       {1, 2}},
      {"equal components", {{{big, {}}, {big, {}}}}, chains_overlap, {0, 0}, {1, 0}},
      {"hole beside", {{{big, {backwards(box(10, 0, 12, 2))}}}}, hole_outside, {1, 0}, {0, 0}},
      {"hole around", {{{box(2, 2, 4, 4), {backwards(big)}}}}, hole_outside, {1, 0}, {0, 0}},
      {"hole touching from outside",
       {{{big, {backwards({{8, 4}, {9, 3}, {9, 5}})}}}},
       hole_outside,
       {1, 0},
       {0, 0}},
      {"hole in a hole",
       {{{big, {backwards(box(1, 1, 7, 7)), backwards(box(2, 2, 3, 3))}}}},
       holes_nested,
       {2, 0},
       {1, 0}},
      {"component in a component",
       {{{big, {}}, {box(2, 2, 3, 3), {}}}},
       components_overlap,
       {1, 0},
       {0, 0}},
      {"component around another's hole",
       {{{big, {backwards(box(3, 3, 4, 4))}}, {box(2, 2, 5, 5), {}}}},
       components_overlap,
       {2, 0},
       {0, 0}},
      {"component in a component, touching it in two vertices",
       {{{big, {}}, {{{0, 0}, {4, 1}, {8, 8}, {1, 4}}, {}}}},
       components_overlap,
       {1, 0},
       {0, 0}},
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

TEST(Validity, of_edges_shows_at_a_point_of_both) {
  using enum DefectKind;
  for (const Invalid& invalid : invalid_regions()) {
    const auto defect = find_defect(invalid.region);
    ASSERT_TRUE(defect) << invalid.name;
    if (defect->kind < self_crossing || defect->kind > chains_overlap) continue;
    const std::vector<Chain> all = chains(invalid.region);
    const auto edge = [&](const VertexIndex& at) { return edges(all[at.chain])[at.vertex]; };
    EXPECT_TRUE(lies_on(defect->where, edge(defect->first))) << invalid.name;
    EXPECT_TRUE(lies_on(defect->where, edge(defect->second))) << invalid.name;
  }
}

TEST(Validity, of_a_spike_is_found) {
  EXPECT_TRUE(find_defect(polygon({{0, 0}, {4, 0}, {4, 2}, {4, 1}, {0, 3}})));
  EXPECT_TRUE(find_defect(polygon({{0, 0}, {6, 0}, {6, 2}, {4, 0}, {2, 0}, {1, 2}})));
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
       {{{big, {}}, {{{8, 4}, {9, 3}, {9, 5}}, {}}}}},
      {"three holes touching in one point",
       {{{big,
          {backwards({{4, 4}, {5, 3}, {5, 5}}), backwards({{4, 4}, {3, 5}, {3, 3}}),
           backwards({{4, 4}, {4, 6}, {Rational(7, 2), 6}})}}}}},
      {"component that fills a hole but for touching points",
       {{{big, {backwards(box(2, 2, 6, 6))}}, {{{4, 2}, {6, 4}, {4, 6}, {2, 4}}, {}}}}},
      {"island in the hole of an island",
       {{{box(0, 0, 9, 9), {backwards(box(1, 1, 8, 8))}},
         {box(2, 2, 7, 7), {backwards(box(3, 3, 6, 6))}},
         {box(4, 4, 5, 5), {}}}}},
      {"the island before what is around it",
       {{{box(2, 2, 3, 3), {}}, {box(0, 0, 5, 5), {backwards(box(1, 1, 4, 4))}}}}},
  };
  for (const Shape& shape : valid) EXPECT_FALSE(find_defect(shape.region)) << shape.name;
  for (const Shape& shape : shapes()) EXPECT_FALSE(find_defect(shape.region)) << shape.name;
}

TEST(Validity, does_not_depend_on_where_a_chain_starts) {
  for (const Shape& shape : shapes()) {
    Region region = shape.region;
    for (Component& component : region.components) {
      for (std::size_t i = 0; i < component.outer.size(); ++i) {
        std::rotate(component.outer.begin(), component.outer.begin() + 1, component.outer.end());
        EXPECT_FALSE(find_defect(region)) << shape.name;
      }
      for (Chain& hole : component.holes) {
        for (std::size_t i = 0; i < hole.size(); ++i) {
          std::rotate(hole.begin(), hole.begin() + 1, hole.end());
          EXPECT_FALSE(find_defect(region)) << shape.name;
        }
      }
    }
  }
}

TEST(Validity, sees_a_crossing_by_less_than_a_double_can_hold) {
  const Rational tiny = 1 / Rational("1" + std::string(400, '0'));
  const Chain outside{{8, 4}, {9, 3}, {9, 5}};
  EXPECT_FALSE(find_defect(Region{{{big, {}}, {outside, {}}}}));
  EXPECT_FALSE(find_defect(Region{{{big, {}}, {translated(outside, {tiny, 0}), {}}}}));
  const auto defect = find_defect(Region{{{big, {}}, {translated(outside, {-tiny, 0}), {}}}});
  ASSERT_TRUE(defect);
  EXPECT_EQ(defect->kind, DefectKind::chains_cross);
}

}  // namespace
}  // namespace oplus
