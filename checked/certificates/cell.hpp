// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "checked/certificates/integer_line.hpp"
#include "checked/pieces/shifted_doubles.hpp"

namespace oplus::certificates {

using pieces::Place;
using pieces::ShiftedDoubles;

/// Where two lines meet, exactly and in doubles.
struct CellCorner {
  CellCorner(HomogeneousPoint point, const ShiftedDoubles& doubles)
      : exact(std::move(point)),
        near{doubles.near(exact.x, exact.w), doubles.near(exact.y, exact.w)} {}

  HomogeneousPoint exact;
  Place near;
};

/// A convex polygon with inner points, counterclockwise. Its corners are where two lines meet: those of
/// sides of a piece, and those along which it was cut. So numbers do not grow with the number of cuts.
struct Cell {
  std::vector<std::shared_ptr<const CellCorner>> corners;
  std::vector<std::shared_ptr<const IntegerLine>>
      lines;  ///< of the side that leaves the corner, either way round; null if that line is not known yet
};

/// Where the corners of a cell are: 1 where the line is positive, 0 on it, -1 beyond.
using Sides = std::vector<int>;

struct HalvedCell {
  Cell positive;
  Cell negative;
  /// Where the line enters the cell and leaves it, with the positive part on its left.
  std::shared_ptr<const CellCorner> from, to;
};

/// Requires: there are corners on both sides.
HalvedCell halved(const Cell& cell, const Sides& sides, const IntegerLine& line,
                  const ShiftedDoubles& doubles);

/// The mean of the corners.
Place centre(const Cell& cell);

}  // namespace oplus::certificates
