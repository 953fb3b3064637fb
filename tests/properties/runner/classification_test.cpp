// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/classification.hpp"

#include <gtest/gtest.h>

#include "reference/definitions/convolution.hpp"

namespace oplus {
namespace {

const Region square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
const Region oblique = polygon({{0, 0}, {5, 2}, {1, 3}});
const Region arrow = polygon({{0, 0}, {7, 1}, {2, 2}, {1, 7}});

TEST(Classification, of_a_plain_pair_is_all_false) {
  for (const auto& [name, value] : named(classify({square, oblique}))) EXPECT_FALSE(value) << name;
}

TEST(Classification, asks_both_for_reflex_vertices) {
  EXPECT_FALSE(classify({arrow, square}).reflex_vertices);
  EXPECT_FALSE(classify({square, arrow}).reflex_vertices);
  EXPECT_TRUE(classify({arrow, arrow}).reflex_vertices);
  // The corners of a hole are the region's reflex vertices.
  const Region frame{{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{1, 1}, {1, 2}, {2, 1}}}}}};
  EXPECT_TRUE(classify({arrow, frame}).reflex_vertices);
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

}  // namespace
}  // namespace oplus
