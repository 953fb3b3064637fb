// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/collision.hpp"

#include <gtest/gtest.h>

#include "tests/reference/definitions/cells.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

struct Placement {
  std::string name;
  Region a;
  Region b;
  bool meet;
};

std::vector<Placement> placements() {
  const Region square = polygon(box(0, 0, 4, 4));
  const Region notched = polygon({{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}});
  const Region frame = holed(box(0, 0, 6, 6), {box(2, 2, 4, 4)});
  const Region pinched = shape("two squares touching in a corner");
  const Region pinched_the_other_way{{{box(0, 1, 1, 2), {}}, {box(1, 0, 2, 1), {}}}};
  const auto at = [](const Region& region, int x, int y) { return translated(region, {x, y}); };
  const auto triangle = [](const Point& a, const Point& b, const Point& c) {
    return polygon({a, b, c});
  };
  return {
      {"edges cross", square, at(square, 1, 1), true},
      {"far apart", square, at(square, 9, 0), false},
      {"vertex to vertex", square, at(square, 4, 4), false},
      {"edge to edge from outside", square, at(square, 4, 1), false},
      {"whole edge to whole edge", square, at(square, 4, 0), false},
      {"equal", square, square, true},
      {"one inside the other", square, polygon(box(1, 1, 2, 2)), true},
      {"one inside, sharing a side", square, polygon(box(0, 1, 2, 2)), true},
      {"sharing two sides, no proper crossing", polygon(box(0, 0, 2, 1)), polygon(box(1, 0, 3, 1)),
       true},
      {"plus sign", polygon(box(1, 0, 2, 3)), polygon(box(0, 1, 3, 2)), true},
      {"vertex through an edge from outside, only touching", square,
       triangle({2, 4}, {3, 5}, {1, 5}), false},
      {"vertex on an edge from inside", square, triangle({2, 4}, {1, 1}, {3, 1}), true},
      {"tip in a reflex notch", notched, triangle({2, 2}, {3, 4}, {1, 4}), false},
      {"tip that fills a reflex notch", notched, triangle({2, 2}, {4, 4}, {0, 4}), false},
      {"tip wider than a reflex notch", notched, triangle({2, 2}, {4, 3}, {0, 3}), true},
      {"tip below a reflex notch, from inside", notched, triangle({2, 2}, {1, 1}, {3, 1}), true},
      {"corners only, all edges' middles outside", polygon(box(0, 0, 2, 2)),
       polygon({{1, 0}, {2, 1}, {1, 2}, {0, 1}}), true},
      {"filling a hole", frame, polygon(box(2, 2, 4, 4)), false},
      {"inside a hole", frame, polygon({{3, 2}, {4, 3}, {3, 4}, {2, 3}}), false},
      {"larger than a hole", frame, polygon(box(1, 1, 5, 5)), true},
      {"the frame without its hole", frame, polygon(box(0, 0, 6, 6)), true},
      {"frame in frame: each in the other's hole or outside", frame,
       holed(box(-1, -1, 7, 7), {box(0, 0, 6, 6)}), false},
      {"pinched chains through each other's pinch", pinched, pinched_the_other_way, false},
      {"pinched chains, equal", pinched, pinched, true},
      {"square over a pinch", pinched, translated(polygon(box(0, 0, 1, 1)), {Rational(1, 2), 1}),
       true},
      {"square beside a pinch", pinched, polygon(box(0, 1, 1, 2)), false},
      {"two components, the second one inside",
       together({polygon(box(9, 9, 10, 10)), polygon(box(1, 1, 2, 2))}), square, true},
      {"empty", Region{}, square, false},
  };
}

TEST(Collision, named_placements) {
  for (const Placement& placement : placements()) {
    EXPECT_EQ(interiors_meet(placement.a, placement.b), placement.meet) << placement.name;
    EXPECT_EQ(interiors_meet(placement.b, placement.a), placement.meet)
        << placement.name << ", swapped";
    EXPECT_EQ(interiors_meet(reflected(placement.a), reflected(placement.b)), placement.meet)
        << placement.name << ", turned over";
  }
}

TEST(Collision, two_regions_meet_where_they_share_a_cell) {
  for (const Shape& a : shapes()) {
    const std::set<Cell> in_a = cells_of(a.region);
    for (const Shape& b : shapes()) {
      const std::set<Cell> in_b = cells_of(b.region);
      // A few placements of each pair; all of them are in hierarchy_collision_test.
      for (int i = -5; i <= 5; i += 5) {
        for (int j = -4; j <= 6; j += 2) {
          const Region moved = translated(b.region, {Rational(i) / 2, Rational(j) / 2});
          ASSERT_EQ(interiors_meet(a.region, moved), share_a_cell(in_a, in_b, i, j))
              << a.name << ", " << b.name << " moved by " << i << "/2 " << j << "/2";
        }
      }
    }
  }
}

}  // namespace
}  // namespace oplus
