// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/region_of.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "reference/chains/touching_points.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/winding_number.hpp"
#include "tests/reference/chains/random_regions.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

/// Valid regions, and what each is as a sum: stitched from its pieces.
template <typename Check>
void for_each_sum(int count, Check check) {
  Random random(24);
  for (int i = 0; i < count; ++i) {
    const Region region = one_in(random, 10) ? random_cells(random) : random_region(random);
    if (!find_defect(region))
      check(region, canonical_sum(BoundaryFeatures{boundary_pieces(region), {}, {}}));
  }
}

TEST(RegionOf, a_sum_is_valid_and_has_the_same_boundary) {
  int apart = 0;
  for_each_sum(3000, [&](const Region& region, const PlanarSet& sum) {
    EXPECT_EQ(canonical_sum(region), sum);
    const Region again = region_of(sum);
    ASSERT_FALSE(find_defect(again)) << testing::PrintToString(sum);
    ASSERT_EQ(canonical_sum(again), sum);
    ASSERT_EQ(area(again), area(region));
    apart += chains(again).size() > sum.outer.size() + sum.holes.size();
  });
  EXPECT_GE(apart, 100) << "chains that touch themselves";
}

/// Whether a chain winds around another, which may touch it: one of the other's pieces decides.
bool is_around(const Chain& outer, const Chain& hole) {
  const std::vector<Segment> around = edges(outer);
  for (const Segment& edge : edges(hole)) {
    for (const Segment& piece : cut_where_met(edge, around)) {
      const Point middle = midpoint(piece.source, piece.target);
      if (!lies_on_one(middle, around)) return winding_number(middle, around) != 0;
    }
  }
  return false;
}

TEST(RegionOf, a_claimed_sum_has_each_hole_in_the_smallest_outer_chain_around_it) {
  int several = 0;
  const auto check = [&](const Region&, const PlanarSet& sum) {
    ClaimedSum expected;
    for (const Chain& outer : sum.outer) expected.region.components.push_back({outer, {}});
    for (const Chain& hole : sum.holes) {
      std::optional<std::size_t> best;
      int around = 0;
      for (std::size_t c = 0; c < sum.outer.size(); ++c) {
        if (!is_around(sum.outer[c], hole)) continue;
        ++around;
        if (!best || twice_area(sum.outer[c]) < twice_area(sum.outer[*best])) best = c;
      }
      ASSERT_TRUE(best);
      expected.region.components[*best].holes.push_back(hole);
      several += around > 1;
    }
    ASSERT_EQ(given(sum), expected);
  };
  for_each_sum(3000, check);
  const Region frames = together(
      {holed(box(0, 0, 20, 20), {box(1, 1, 19, 19)}), holed(box(2, 2, 8, 8), {box(3, 3, 7, 7)}),
       polygon(box(4, 4, 5, 5)), holed(box(9, 2, 18, 18), {box(10, 3, 12, 9), box(13, 3, 17, 4)})});
  check(frames, canonical_sum(frames));
  EXPECT_EQ(several, 3) << "holes inside several outer chains";
}

TEST(RegionOf, a_given_hole_alone_is_a_component_without_an_outer_chain) {
  const Chain hole = backwards(box(5, 0, 6, 1));
  const ClaimedSum sum = given({{box(0, 0, 4, 4)}, {hole}, {}, {}});
  EXPECT_EQ(sum.region, (Region{{{box(0, 0, 4, 4), {}}, {{}, {hole}}}}));
}

}  // namespace
}  // namespace oplus
