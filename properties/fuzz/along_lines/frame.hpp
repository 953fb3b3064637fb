// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "reference/definitions/point.hpp"
#include "reference/definitions/region.hpp"

namespace oplus::along_lines {

/// How coordinates become integers, as small as possible: less that of the summand's first vertex, and
/// times a factor.
struct Frame {
  Point first_of_p, first_of_q;
  Rational factor = 1;
  std::size_t bits = 1;  ///< of the largest coordinate of a vertex sum, apart from the sign

  /// Of a point of the sum.
  Point in(const Point& x) const { return factor * (x - first_of_p - first_of_q); }
  Point back(const Rational& x, const Rational& y) const {
    return {x / factor + first_of_p.x + first_of_q.x, y / factor + first_of_p.y + first_of_q.y};
  }
};

/// Requires: neither is empty.
Frame frame_of(const Region& p, const Region& q);

}  // namespace oplus::along_lines
