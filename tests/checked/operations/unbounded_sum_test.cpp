// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/unbounded_sum.hpp"

#include <gtest/gtest.h>

#include "checked/operations/complement.hpp"
#include "checked/slide/slide.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/difference.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

PlanarSet slid(const Region& p, const Region& q, Boundary boundary) {
  return slide_sum(p, q, boundary).sum;
}

PlanarSet sum(const Region& p, const Region& q, Boundary boundary = Boundary::closed) {
  return unbounded_sum(p, q, boundary, slid);
}

const Region room = complement(polygon(box(0, 0, 9, 5)));
const Region plane = {{Component{}}};

TEST(UnboundedSum, of_bounded_regions_is_their_sum) {
  const Region square = polygon(box(0, 0, 1, 1));
  EXPECT_EQ(sum(square, square), slid(square, square, Boundary::closed));
}

TEST(UnboundedSum, shrinks_what_is_free) {
  const Region expected = complement(polygon(box(2, 1, 9, 5)));
  EXPECT_EQ(sum(room, polygon(box(0, 0, 2, 1))), canonical_sum(expected));
  EXPECT_EQ(sum(polygon(box(0, 0, 2, 1)), room), canonical_sum(expected));
}

TEST(UnboundedSum, open_keeps_exact_fits) {
  const PlanarSet wide = sum(room, polygon(box(0, 0, 2, 5)), Boundary::open);
  EXPECT_TRUE(wide.is_unbounded && wide.holes.empty() && wide.outer.empty());
  EXPECT_EQ(wide.dangling_edges, (std::vector<Segment>{{{2, 5}, {9, 5}}}));
  const PlanarSet exact = sum(room, polygon(box(0, 0, 9, 5)), Boundary::open);
  EXPECT_EQ(exact.isolated_vertices, (std::vector<Point>{{9, 5}}));
}

/// However far apart its components are: the frame must be further away than they are.
TEST(UnboundedSum, of_a_summand_of_distant_parts_is_right) {
  const Region apart = together({polygon(box(0, 0, 1, 1)), polygon(box(1000, 300, 1001, 301))});
  EXPECT_EQ(sum(room, apart), canonical_sum(plane));
  const Region other = together({polygon(box(0, 0, 1, 1)), polygon(box(5, 0, 6, 1))});
  const PlanarSet rest = sum(room, other);
  EXPECT_EQ(rest.holes, (std::vector<Chain>{{{6, 1}, {6, 5}, {9, 5}, {9, 1}}}));
}

TEST(UnboundedSum, with_nothing_is_nothing_and_with_another_is_the_plane) {
  EXPECT_EQ(sum(room, Region{}), PlanarSet{});
  EXPECT_EQ(sum(Region{}, plane), PlanarSet{});
  EXPECT_EQ(sum(room, room), canonical_sum(plane));
  EXPECT_EQ(sum(plane, polygon(box(0, 0, 1, 1))), canonical_sum(plane));
}

}  // namespace
}  // namespace oplus
