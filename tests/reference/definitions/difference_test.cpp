// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/difference.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/chains/region_of.hpp"
#include "reference/families/family.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

/// Each chain by its own winding numbers: another way to the same answer.
Location located(const Point& p, const PlanarSet& sum) {
  for (const Segment& e : sum.dangling_edges)
    if (lies_on(p, e)) return Location::boundary;
  const std::vector<Point>& isolated = sum.isolated_vertices;
  if (std::count(isolated.begin(), isolated.end(), p) > 0) return Location::boundary;
  return locate(p, region_of(sum));
}

/// Returns the difference, after checking its witness.
std::optional<Difference> checked_difference(const PlanarSet& a, const PlanarSet& b) {
  const std::optional<Difference> d = difference(a, b);
  EXPECT_EQ(d.has_value(), a != b);
  if (!d) return d;
  EXPECT_NE(d->in_a, d->in_b) << d->what;
  EXPECT_EQ(d->in_a, located(d->witness, a)) << d->what;
  EXPECT_EQ(d->in_b, located(d->witness, b)) << d->what;
  const bool regular_differ = a.outer != b.outer || a.holes != b.holes;
  EXPECT_EQ(regular_differ, d->in_a != Location::boundary && d->in_b != Location::boundary)
      << d->what;
  return d;
}

PlanarSet square(std::vector<Segment> dangling_edges = {},
                 std::vector<Point> isolated_vertices = {}) {
  return {{box(0, 0, 4, 4)}, {}, std::move(dangling_edges), std::move(isolated_vertices)};
}

TEST(Difference, of_generated_regions_has_a_true_witness) {
  for (const Family& family : families()) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(family.name + " " + std::to_string(seed));
      const Summands pair = generate(family, std::max(family.smallest, family.typical), seed);
      const PlanarSet p = canonical_sum(pair.p);
      const PlanarSet q = canonical_sum(pair.q);
      checked_difference(p, q);
      checked_difference(q, p);
      checked_difference(p, p);
      checked_difference(p, canonical_sum(translated(pair.p, {Rational(1, 1000), 0})));
    }
  }
}

TEST(Difference, a_chain_that_touches_an_edge_in_its_middle) {
  // The diamond's corner is the middle of the square's edge, and its normal runs into the diamond.
  const Chain diamond{{2, 0}, {3, 1}, {2, 2}, {1, 1}};
  const PlanarSet touched = canonical_sum(holed(box(0, 0, 4, 4), {diamond}));
  checked_difference(touched, PlanarSet{});
  checked_difference(touched, canonical_sum(polygon(diamond)));
}

TEST(Difference, a_missing_hole_has_a_witness_in_it) {
  PlanarSet frame = square();
  frame.holes = {backwards(box(1, 1, 2, 2)), backwards(box(2, 2, 3, 3))};
  for (Chain& hole : frame.holes) std::rotate(hole.begin(), std::prev(hole.end()), hole.end());
  PlanarSet one_less = frame;
  one_less.holes.pop_back();
  const auto d = checked_difference(frame, one_less);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->in_a, Location::outside);
  EXPECT_EQ(locate(d->witness, polygon(box(2, 2, 3, 3))), Location::inside);
  EXPECT_EQ(d->what, "a hole of the first is filled, wholly or in part, in the second");
}

TEST(Difference, of_dangling_edges_avoids_isolated_vertices) {
  const PlanarSet a = square({{{1, 1}, {3, 1}}});
  const PlanarSet b = square({}, {{2, 1}});  // the middle of the edge
  const auto d = checked_difference(a, b);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->what, "a dangling edge of the first is not one of the second");
  EXPECT_EQ(checked_difference(b, a)->what,
            "a dangling edge of the second is not one of the first");
}

TEST(Difference, steps_past_low_dimensional_features) {
  // Half way from the bottom's middle to the top.
  const PlanarSet dot = square({}, {{2, 2}});
  const PlanarSet across = square({{{1, 2}, {3, 2}}});
  const PlanarSet along = square({{{2, 1}, {2, 3}}});
  for (const PlanarSet& a : {dot, across, along})
    EXPECT_EQ(checked_difference(a, PlanarSet{})->in_a, Location::inside);
}

TEST(Difference, of_values_that_are_not_canonical_still_says_something) {
  PlanarSet turned = square();
  std::rotate(turned.outer[0].begin(), turned.outer[0].begin() + 1, turned.outer[0].end());
  const auto d = difference(square(), turned);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->in_a, d->in_b);
  EXPECT_NE(d->what.find("canonical"), std::string::npos);
}

}  // namespace
}  // namespace oplus
