// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/operations/complement.hpp"
#include "checked/operations/operations.hpp"
#include "checked/slide/slide.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/oracle/operations_by_definition.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

PlanarSet by_slide(const Region& p, const Region& q, Boundary boundary) {
  return slide_sum(p, q, boundary).sum;
}

/// The value of an operation, which must be the same by its definition.
PlanarSet value(const std::string& name, const Region& p, const Region& q) {
  const PlanarSet right = find_defined_operation(name)->compute(p, q);
  for (const Operation& operation : operations()) {
    if (operation.name != name) continue;
    EXPECT_EQ(operation.compute(p, q, by_slide), right) << name;
    return right;
  }
  ADD_FAILURE() << "no operation " << name;
  return right;
}

PlanarSet edges_and_points(const std::vector<Segment>& edges, const std::vector<Point>& points) {
  return {{}, {}, edges, points};
}

const Chain key = {{0, 0}, {5, 0}, {5, 1}, {4, 1}, {4, 3}, {3, 3}, {3, 1}, {0, 1}};

TEST(ExactPlacements, a_part_as_large_as_its_bin_has_one_placement) {
  const Region bin = polygon(box(10, 20, 110, 120)), part = polygon(box(0, 0, 100, 100));
  EXPECT_EQ(value("ifp", bin, part), edges_and_points({}, {{10, 20}}));
  EXPECT_EQ(value("erode", bin, part), PlanarSet{});
  EXPECT_EQ(value("open", bin, part), canonical_sum(bin));
  EXPECT_EQ(value("close", bin, part), canonical_sum(bin));
  EXPECT_EQ(value("ifp", polygon(box(10, 20, 110, Rational(2399, 20))), part), PlanarSet{});
}

TEST(ExactPlacements, a_key_in_its_keyhole) {
  EXPECT_EQ(value("ifp", translated(polygon(key), {7, 2}), polygon(key)),
            edges_and_points({}, {{7, 2}}));
  const Region plate = holed(box(5, 0, 15, 10), {translated(key, {7, 2})});
  const PlanarSet free = value("ifp", complement(plate), polygon(key));
  EXPECT_TRUE(free.is_unbounded);
  EXPECT_EQ(free.isolated_vertices, (std::vector<Point>{{7, 2}}));
  EXPECT_TRUE(free.dangling_edges.empty());
  EXPECT_EQ(value("nfp", plate, polygon(key)).isolated_vertices, free.isolated_vertices);
}

TEST(ExactPlacements, a_door_as_wide_as_the_robot) {
  // Two rooms of 4 x 4, and between them a passage 2 long and 2 wide.
  const Region rooms = polygon({{0, 0},
                                {4, 0},
                                {4, 1},
                                {6, 1},
                                {6, 0},
                                {10, 0},
                                {10, 4},
                                {6, 4},
                                {6, 3},
                                {4, 3},
                                {4, 4},
                                {0, 4}});
  const PlanarSet free = value("ifp", rooms, polygon(box(0, 0, 2, 2)));
  EXPECT_EQ(free.outer, (std::vector<Chain>{box(0, 0, 2, 2), box(6, 0, 8, 2)}));
  EXPECT_EQ(free.dangling_edges, (std::vector<Segment>{{{2, 1}, {6, 1}}}));
  EXPECT_TRUE(free.isolated_vertices.empty());
  EXPECT_EQ(value("open", rooms, polygon(box(0, 0, 2, 2))), canonical_sum(rooms));
  // The walls between them are closed by a robot of that size, and not by a smaller one.
  const Region walls = together({polygon(box(4, 0, 6, 1)), polygon(box(4, 3, 6, 4))});
  EXPECT_EQ(value("close", walls, polygon(box(0, 0, 2, 2))),
            canonical_sum(polygon(box(4, 0, 6, 4))));
  EXPECT_EQ(value("close", walls, polygon(box(0, 0, 1, 1))), canonical_sum(walls));
}

TEST(ExactPlacements, a_corridor_of_an_l_shaped_bin) {
  const Region bin = polygon({{0, 0}, {9, 0}, {9, 2}, {4, 2}, {4, 9}, {0, 9}});
  const PlanarSet free = value("ifp", bin, polygon(box(0, 0, 2, 2)));
  EXPECT_EQ(free.outer, (std::vector<Chain>{box(0, 0, 2, 7)}));
  EXPECT_EQ(free.dangling_edges, (std::vector<Segment>{{{2, 0}, {7, 0}}}));
  EXPECT_EQ(value("open", bin, polygon(box(0, 0, 2, 2))), canonical_sum(bin));
  EXPECT_EQ(value("erode", bin, polygon(box(0, 0, 2, 2))), canonical_sum(polygon(box(0, 0, 2, 7))));
}

TEST(ExactPlacements, a_part_with_a_hole_around_an_island) {
  // A pillar of 1 x 1 in the middle of a bin of 7 x 7, and a frame of 3 x 3 that just fits around it, or
  // beside it.
  const Region bin = holed(box(0, 0, 7, 7), {box(3, 3, 4, 4)});
  const Region frame = holed(box(0, 0, 3, 3), {box(1, 1, 2, 2)});
  EXPECT_EQ(
      value("ifp", bin, frame),
      edges_and_points({{{0, 0}, {0, 4}}, {{0, 0}, {4, 0}}, {{0, 4}, {4, 4}}, {{4, 0}, {4, 4}}},
                       {{2, 2}}));
  // Around the pillar it covers what is left of the frame's copies beside it.
  EXPECT_EQ(value("open", bin, frame), canonical_sum(bin));
}

TEST(ExactPlacements, without_a_part_everywhere_and_in_nothing_nowhere) {
  const Region square = polygon(box(0, 0, 1, 1));
  PlanarSet plane;
  plane.is_unbounded = true;
  EXPECT_EQ(value("ifp", square, Region{}), plane);
  EXPECT_EQ(value("ifp", Region{}, square), PlanarSet{});
  EXPECT_EQ(value("ifp", region_of(plane), square), plane);
  EXPECT_EQ(value("nfp", region_of(plane), square), plane);
  EXPECT_EQ(value("nfp", square, Region{}), PlanarSet{});
  EXPECT_EQ(value("ifp", square, region_of(plane)), PlanarSet{});
}

TEST(ExactPlacements, of_both_unbounded_regions) {
  // The plane without a square of 2 x 2 is inside the plane without one of 1 x 1 while that is in the square.
  const Region q = complement(polygon(box(0, 0, 2, 2))), p = complement(polygon(box(0, 0, 1, 1)));
  EXPECT_EQ(value("ifp", p, q), canonical_sum(polygon(box(-1, -1, 0, 0))));
  EXPECT_EQ(value("ifp", q, q), edges_and_points({}, {{0, 0}}));
  EXPECT_EQ(value("ifp", q, p), PlanarSet{});
}

}  // namespace
}  // namespace oplus
