// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/classification.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/definitions/convolution.hpp"

namespace oplus {
namespace {

const Region square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
const Region oblique = polygon({{0, 0}, {5, 2}, {1, 3}});
const Region arrow = polygon({{0, 0}, {7, 1}, {2, 2}, {1, 7}});

TEST(Classification, of_a_plain_pair_is_all_false) {
  for (const auto& [name, value] : named(classify({square, oblique}))) EXPECT_FALSE(value) << name;
}

TEST(Classification, sees_holes) {
  const Region frame{{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{1, 1}, {1, 2}, {2, 1}}}}}};
  EXPECT_TRUE(classify({frame, oblique}).holes);
  EXPECT_TRUE(classify({oblique, frame}).holes);
  EXPECT_FALSE(classify({oblique, frame}).several_components);
}

TEST(Classification, sees_several_components) {
  Region two = square;
  two.components.push_back({{{5, 5}, {6, 5}, {6, 6}}, {}});
  EXPECT_TRUE(classify({two, oblique}).several_components);
  EXPECT_TRUE(classify({oblique, two}).several_components);
  EXPECT_FALSE(classify({oblique, two}).holes);
}

TEST(Classification, asks_both_for_reflex_vertices) {
  EXPECT_FALSE(classify({arrow, square}).reflex_vertices);
  EXPECT_FALSE(classify({square, arrow}).reflex_vertices);
  EXPECT_TRUE(classify({arrow, arrow}).reflex_vertices);
  // The corners of a hole are the region's reflex vertices.
  const Region frame{{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{1, 1}, {1, 2}, {2, 1}}}}}};
  EXPECT_TRUE(classify({arrow, frame}).reflex_vertices);
}

TEST(Classification, sees_equal_and_opposite_directions) {
  const Region same = polygon({{0, 0}, {3, 0}, {1, 2}});  // an edge in direction (1, 0)
  const Region opposite = polygon({{0, 0}, {-1, -2}, {2, -2}});
  EXPECT_TRUE(classify({same, opposite}).parallel_edges);
  const Region above = polygon({{0, 5}, {-1, -2}, {7, -3}});
  EXPECT_FALSE(classify({same, above}).parallel_edges);
  const Region up = polygon({{0, 0}, {5, 1}, {0, 4}});         // an edge in direction (0, -1)
  const Region vertical = polygon({{0, 0}, {0, 7}, {-3, 1}});  // (0, 1)
  EXPECT_TRUE(classify({up, vertical}).parallel_edges);
}

TEST(Classification, sees_collinear_vertices) {
  const Region straight = polygon({{0, 0}, {1, 0}, {3, 0}, {1, 2}});
  EXPECT_TRUE(classify({straight, oblique}).collinear_vertices);
  EXPECT_TRUE(classify({oblique, straight}).collinear_vertices);
}

/// By the definition: all pairs.
bool some_overlap(const Summands& summands) {
  const std::vector<Segment> all = segments(reduced_convolution(summands.p, summands.q));
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(all[i], all[j])) return true;
  return false;
}

TEST(Classification, overlaps_are_those_of_all_pairs) {
  int with = 0;
  int without = 0;
  for (const char* name : {"grid", "tight", "components", "simple"}) {
    const Family& family = *find_family(name);
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const Summands summands = generate(family, family.typical, seed);
      const bool expected = some_overlap(summands);
      EXPECT_EQ(classify(summands).overlapping_segments, expected) << name << " seed " << seed;
      (expected ? with : without) += 1;
    }
  }
  EXPECT_GE(with, 40);
  EXPECT_GE(without, 40);
}

TEST(Classification, names_all_six) { EXPECT_EQ(named(Classification{}).size(), 6u); }

}  // namespace
}  // namespace oplus
