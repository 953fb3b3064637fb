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

TEST(Difference, far_away_and_of_features_that_both_have) {
  PlanarSet around;
  around.holes = {backwards(box(0, 0, 4, 4))};
  around.is_unbounded = true;
  const auto far = difference(around, square());
  ASSERT_TRUE(far);
  EXPECT_EQ(far->what, "the first covers a place outside the second");
  EXPECT_EQ(far->witness, (Point{5, 4}));
  EXPECT_EQ(difference(square(), around)->what, "the second covers a place outside the first");

  const Segment common{{1, 1}, {3, 1}};
  EXPECT_EQ(checked_difference(square({common, {{1, 2}, {3, 2}}}), square({common}))->witness,
            (Point{2, 2}));
  EXPECT_EQ(checked_difference(square({}, {{1, 1}, {2, 2}}), square({}, {{1, 1}}))->witness,
            (Point{2, 2}));
}

TEST(Difference, of_an_edge_with_the_same_on_both_sides) {
  const PlanarSet twice{{box(0, 0, 4, 4), backwards(box(0, 0, 4, 4))}, {}, {}, {}};
  EXPECT_EQ(difference(twice, {})->what, "an edge of the first has the same on both sides");
  EXPECT_EQ(difference({}, twice)->what, "an edge of the second has the same on both sides");
}

TEST(Difference, of_the_same_points_in_other_pieces) {
  const std::string same = "the same points, but one of the two is not in canonical form";
  const PlanarSet halved = square({{{1, 1}, {2, 1}}, {{2, 1}, {3, 1}}});
  EXPECT_EQ(difference(square({{{1, 1}, {3, 1}}}), halved)->what, same);
  PlanarSet more = square();
  more.outer[0].insert(more.outer[0].begin() + 1, {2, 0});
  EXPECT_EQ(difference(more, square())->what, same);
  EXPECT_EQ(difference({{}, {}, {}, {{1, 1}, {1, 1}}}, {{}, {}, {}, {{1, 1}}})->what, same);
  const Segment edge{{1, 1}, {3, 1}};
  EXPECT_EQ(difference(square({edge}, {{2, 1}}), square({edge}))->what, same);
  const PlanarSet twice{{box(0, 0, 4, 4), backwards(box(0, 0, 4, 4))}, {}, {}, {}};
  EXPECT_EQ(difference(twice, {{}, {}, edges(twice), {}})->what, same);
}

}  // namespace
}  // namespace oplus
