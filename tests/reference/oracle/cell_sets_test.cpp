// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/oracle/cell_sets.hpp"

#include <gtest/gtest.h>

#include "reference/definitions/verdicts_differ.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

/// A square, and a segment that sticks out of it and on which a point is marked.
std::vector<Segment> square_and_tail() {
  std::vector<Segment> all = edges(box(0, 0, 2, 2));
  all.push_back({{2, 1}, {4, 1}});
  all.push_back({{4, 1}, {6, 1}});
  return all;
}

bool in_square(const Point& p) { return locate(p, polygon(box(0, 0, 2, 2))) != Location::outside; }

TEST(SetWhere, a_closed_set_has_the_edges_and_points_that_are_in_it) {
  const PlanarSet set = set_where(square_and_tail(), Boundary::closed, [](const Point& p) {
    return in_square(p) || (p.y == 1 && p.x >= 2 && p.x <= 4) || p == Point{6, 1};
  });
  EXPECT_EQ(set, (PlanarSet{{box(0, 0, 2, 2)}, {}, {{{2, 1}, {4, 1}}}, {{6, 1}}}));
}

TEST(SetWhere, an_open_set_has_those_that_are_missing) {
  const PlanarSet set = set_where(square_and_tail(), Boundary::open, [](const Point& p) {
    return !(in_square(p) || (p.y == 1 && p.x >= 2 && p.x <= 4) || p == Point{6, 1});
  });
  PlanarSet expected{{}, {backwards(box(0, 0, 2, 2))}, {{{2, 1}, {4, 1}}}, {{6, 1}}};
  expected.holes[0] = {{0, 0}, {0, 2}, {2, 2}, {2, 0}};
  expected.is_unbounded = true;
  EXPECT_EQ(set, expected);
}

TEST(SetWhere, of_nothing_is_the_plane_or_empty) {
  EXPECT_EQ(set_where({}, Boundary::closed, [](const Point&) { return false; }), PlanarSet{});
  EXPECT_TRUE(set_where({}, Boundary::open, [](const Point&) { return true; }).is_unbounded);
}

TEST(SetWhere, refuses_what_is_not_closed_or_not_open) {
  const auto inside = [](const Point& p) {
    return locate(p, polygon(box(0, 0, 2, 2))) == Location::inside;
  };
  EXPECT_THROW(set_where(square_and_tail(), Boundary::closed, inside), VerdictsDiffer);
  EXPECT_THROW(set_where(square_and_tail(), Boundary::open, in_square), VerdictsDiffer);
  // An edge without its ends, and a point alone.
  EXPECT_THROW(set_where(square_and_tail(), Boundary::closed,
                         [](const Point& p) { return p.y == 1 && p.x > 2 && p.x < 4; }),
               VerdictsDiffer);
  EXPECT_THROW(set_where(square_and_tail(), Boundary::open,
                         [](const Point& p) {
                           return p == Point{6, 1};
                         }),
               VerdictsDiffer);
}

}  // namespace
}  // namespace oplus
