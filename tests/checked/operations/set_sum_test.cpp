// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/set_sum.hpp"

#include <gtest/gtest.h>

#include "checked/operations/union_of.hpp"
#include "checked/slide/by_slide.hpp"
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

const std::string square = "POLYGON((0 0,1 0,1 1,0 1,0 0))";

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
  const PlanarSet closed = set_sum(value(p), value(q), Boundary::closed, by_slide);
  const PlanarSet open = set_sum(value(p), value(q), Boundary::open, by_slide);
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
