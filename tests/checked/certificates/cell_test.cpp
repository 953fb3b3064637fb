// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/cell.hpp"

#include <gtest/gtest.h>

#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::certificates {
namespace {

Cell cell_of(const Chain& chain) {
  Cell cell;
  for (const Point& p : chain)
    cell.corners.push_back(std::make_shared<const CellCorner>(homogeneous(p), ShiftedDoubles()));
  cell.lines.resize(chain.size());
  return cell;
}

Chain chain_of(const Cell& cell) {
  Chain chain;
  for (const auto& corner : cell.corners) {
    const auto& [x, y, w] = corner->exact;
    chain.push_back({Rational(x) / Rational(w), Rational(y) / Rational(w)});
  }
  return chain;
}

HalvedCell halved(const Cell& cell, const IntegerLine& line) {
  Sides sides;
  for (const auto& corner : cell.corners) sides.push_back(side_of(line, corner->exact));
  return halved(cell, sides, line, {});
}

TEST(Cell, is_halved_across_sides) {
  const auto [upper, lower, from, to] =
      halved(cell_of(box(0, 0, 4, 2)), {-1, 4, -2});  // y = x/4 + 1/2
  EXPECT_EQ(chain_of(upper), (Chain{{4, Rational(3, 2)}, {4, 2}, {0, 2}, {0, Rational(1, 2)}}));
  EXPECT_EQ(chain_of(lower), (Chain{{0, 0}, {4, 0}, {4, Rational(3, 2)}, {0, Rational(1, 2)}}));
  EXPECT_EQ(point_of(from->exact), (Point{0, Rational(1, 2)}));
  EXPECT_EQ(point_of(to->exact), (Point{4, Rational(3, 2)}));
}

TEST(Cell, is_halved_through_corners) {
  const auto [left, right, from, to] = halved(cell_of(box(0, 0, 2, 2)), {-1, 1, 0});
  EXPECT_EQ(chain_of(left), (Chain{{0, 0}, {2, 2}, {0, 2}}));
  EXPECT_EQ(chain_of(right), (Chain{{0, 0}, {2, 0}, {2, 2}}));
  EXPECT_EQ(point_of(from->exact), (Point{0, 0}));
  EXPECT_EQ(point_of(to->exact), (Point{2, 2}));
}

/// Corners of what was cut twice are where two lines meet, also where both are cuts.
TEST(Cell, parts_are_halved_again) {
  const Cell left = halved(cell_of(box(0, 0, 2, 2)), {-1, 1, 0}).positive;
  const auto [above, below, from, to] = halved(left, {1, 1, -2});
  EXPECT_EQ(chain_of(above), (Chain{{1, 1}, {2, 2}, {0, 2}}));
  EXPECT_EQ(chain_of(below), (Chain{{0, 0}, {1, 1}, {0, 2}}));
  EXPECT_EQ(point_of(from->exact), (Point{0, 2}));
  EXPECT_EQ(point_of(to->exact), (Point{1, 1}));
  for (const Cell* cell : {&above, &below}) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!cell->lines[k]) continue;
      EXPECT_EQ(side_of(*cell->lines[k], cell->corners[k]->exact), 0);
      EXPECT_EQ(side_of(*cell->lines[k], cell->corners[(k + 1) % 3]->exact), 0);
    }
  }
}

}  // namespace
}  // namespace oplus::certificates
