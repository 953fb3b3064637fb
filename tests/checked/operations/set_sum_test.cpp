// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/set_sum.hpp"

#include <gtest/gtest.h>

#include "checked/operations/union_of.hpp"
#include "checked/slide/slide.hpp"
#include "properties/statements/placements/sets_meet.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/families/family.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {
namespace {

PlanarSet set(const std::string& text) {
  const ReadSet read = read_set(text, "text");
  return union_of(read.region, read.segments, read.points);
}

PlanarSet sum_by_slide(const Region& p, const Region& q, Boundary boundary) {
  return slide_sum(p, q, boundary).sum;
}

std::string sum(const std::string& p, const std::string& q, Boundary boundary = Boundary::closed) {
  const PlanarSet result = set_sum(set(p), set(q), boundary, sum_by_slide);
  EXPECT_EQ(set_sum(set(q), set(p), boundary, sum_by_slide), result);
  EXPECT_EQ(read_sum(wkt(result), "sum").sum, result) << "not canonical";
  return wkt(result);
}

const std::string square = "POLYGON((0 0,1 0,1 1,0 1,0 0))";

TEST(SetSum, of_a_point_is_a_translation) {
  EXPECT_EQ(sum("POINT(2 3)", square), "POLYGON ((2 3, 3 3, 3 4, 2 4, 2 3))");
  EXPECT_EQ(sum("POINT(2 3)", square, Boundary::open), "POLYGON ((2 3, 3 3, 3 4, 2 4, 2 3))");
  EXPECT_EQ(sum("POINT(2 3)", "LINESTRING(0 0,1 0,1 1)"),
            "GEOMETRYCOLLECTION (LINESTRING (2 3, 3 3), LINESTRING (3 3, 3 4))");
  EXPECT_EQ(sum("POINT(2 3)", "MULTIPOINT(1 1,0 0)"),
            "GEOMETRYCOLLECTION (POINT (2 3), POINT (3 4))");
  EXPECT_EQ(sum("POINT EMPTY", square), "POLYGON EMPTY");
}

TEST(SetSum, of_a_polyline_and_a_region_is_what_the_region_sweeps) {
  EXPECT_EQ(sum("LINESTRING(0 0,4 0,4 3)", square),
            "POLYGON ((0 0, 5 0, 5 4, 4 4, 4 1, 0 1, 0 0))");
  EXPECT_EQ(sum("LINESTRING(0 0,4 0,4 3)", square, Boundary::open),
            "POLYGON ((0 0, 5 0, 5 4, 4 4, 4 1, 0 1, 0 0))");
  // A closed polyline: a frame, its inside is free.
  EXPECT_EQ(sum("LINESTRING(0 0,3 0,3 3,0 3,0 0)", square),
            "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))");
  // Back and forth over itself.
  EXPECT_EQ(sum("LINESTRING(0 0,4 0,1 0,2 0)", square), "POLYGON ((0 0, 5 0, 5 1, 0 1, 0 0))");
}

TEST(SetSum, of_two_segments_is_a_parallelogram_or_a_segment) {
  EXPECT_EQ(sum("LINESTRING(0 0,2 1)", "LINESTRING(1 3,0 0)"),
            "POLYGON ((0 0, 2 1, 3 4, 1 3, 0 0))");
  EXPECT_EQ(sum("LINESTRING(0 0,2 1)", "LINESTRING(4 2,0 0)"),
            "GEOMETRYCOLLECTION (LINESTRING (0 0, 6 3))");
  EXPECT_EQ(sum("LINESTRING(0 0,3 0,4 2)", "LINESTRING(0 0,2 0,2 -2)"),
            "GEOMETRYCOLLECTION (POLYGON ((2 -2, 5 -2, 6 0, 6 2, 4 2, 3 0, 2 0, 2 -2)), "
            "LINESTRING (0 0, 2 0))");
  EXPECT_EQ(sum("LINESTRING(0 0,3 0,4 2)", "LINESTRING(0 0,2 0,2 -2)", Boundary::open),
            "POLYGON EMPTY");
}

TEST(SetSum, keeps_what_just_fits_out_of_the_open_sum) {
  const std::string robot = "POLYGON((0 0,-2 0,-2 -2,0 -2,0 0))";
  EXPECT_EQ(
      sum("MULTILINESTRING((0 0,8 0,8 6,0 6,0 0),(4 0,4 2),(4 4,4 6))", robot, Boundary::open),
      "GEOMETRYCOLLECTION (POLYGON ((-2 -2, 8 -2, 8 6, -2 6, -2 -2), (0 0, 0 4, 2 4, 2 0, 0 0), "
      "(4 0, 4 4, 6 4, 6 0, 4 0)), LINESTRING (2 2, 4 2))");
  EXPECT_EQ(sum("LINESTRING(0 0,2 0,2 2,0 2,0 0)", robot, Boundary::open),
            "GEOMETRYCOLLECTION (POLYGON ((-2 -2, 2 -2, 2 2, -2 2, -2 -2)), POINT (0 0))");
  EXPECT_EQ(sum("LINESTRING(0 0,2 0,2 2,0 2,0 0)", robot),
            "POLYGON ((-2 -2, 2 -2, 2 2, -2 2, -2 -2))");
}

/// Between two triangles that touch, and from a hole into the outside where it touches the outer chain.
TEST(SetSum, sees_a_segment_that_passes_where_chains_touch) {
  EXPECT_EQ(
      sum("MULTIPOLYGON(((1 2,3 2,3 3,1 2)),((3 3,5 3,5 4,3 3)))", "LINESTRING(0 2,2 0)",
          Boundary::open),
      "GEOMETRYCOLLECTION (POLYGON ((1 4, 3 2, 5 2, 5 3, 7 3, 7 4, 5 6, 1 4)), LINESTRING (3 5, 5 3))");
}

TEST(SetSum, of_regions_is_what_the_engine_says) {
  EXPECT_EQ(set_sum(set(square), set(square), Boundary::closed,
                    [](const Region&, const Region&, Boundary) { return set("POINT(7 7)"); }),
            set("POINT(7 7)"));
}

/// Compares both sums with their definitions; returns the number of points.
std::size_t expect_sums_of_the_definition(const ClaimedSum& p, const ClaimedSum& q) {
  const auto value = [](const ClaimedSum& parts) {
    return union_of(parts.region, parts.dangling_edges, parts.isolated_vertices);
  };
  const PlanarSet closed = set_sum(value(p), value(q), Boundary::closed, sum_by_slide);
  const PlanarSet open = set_sum(value(p), value(q), Boundary::open, sum_by_slide);
  const std::vector<Point> points = points_of_cells(p, q);
  for (const Point& x : points) {
    const ClaimedSum placed = reflected_to(x, q);
    EXPECT_EQ(meet(p, placed), locate(x, closed) != Location::outside) << to_string(x);
    EXPECT_EQ(interior_meets(p.region, placed) || interior_meets(placed.region, p),
              locate(x, open) == Location::inside)
        << to_string(x);
  }
  return points.size();
}

/// Clipper2's issue 409 expects a convex polygon.
TEST(SetSum, of_a_convex_polygon_and_a_segment_is_convex) {
  EXPECT_EQ(sum("POLYGON((0 5,-5 2,-3 -4,3 -4,5 2,0 5))", "LINESTRING(0 0,1 0)"),
            "POLYGON ((-5 2, -3 -4, 4 -4, 6 2, 1 5, 0 5, -5 2))");
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}
  int below(int n) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<int>((state_ >> 33U) % static_cast<std::uint64_t>(n));
  }
  Point point() {
    const int x = below(4);
    return {x, below(4)};
  }

 private:
  std::uint64_t state_;
};

ClaimedSum drawn(Draw& draw, const Region& region) {
  ClaimedSum result;
  const int kinds = 1 + draw.below(7);
  if ((kinds & 1) != 0) result.region = region;
  if ((kinds & 2) != 0) {
    Point from = draw.point();
    for (int i = draw.below(3); i >= 0; --i) {
      const Point to = draw.point();
      result.dangling_edges.push_back({from, to});
      from = to;
    }
  }
  if ((kinds & 4) != 0) result.isolated_vertices = {draw.point(), draw.point()};
  return result;
}

/// Regions of the grid, polylines and points, of 4 x 4 places: what is collinear, overlaps and touches.
TEST(SetSum, is_that_of_the_definition_on_a_point_of_every_cell) {
  const Family& grid = *find_family("grid");
  std::size_t points = 0;
  for (std::uint64_t seed = 0; seed < 40 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Draw draw(seed);
    const Summands regions = generate(grid, 4, seed);
    const ClaimedSum p = drawn(draw, regions.p), q = drawn(draw, regions.q);
    points += expect_sums_of_the_definition(p, q);
  }
  EXPECT_GT(points, 3000U);
}

}  // namespace
}  // namespace oplus
