// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"
#include "reference/families/random.hpp"

namespace oplus {

/// Segments between points of a small grid: they cross, touch, overlap, are equal or points, and many
/// meet in one point. In every second case the grid is mapped so that no coordinate is a double.
inline std::vector<Segment> random_segments(Random& random) {
  const int size = uniform(random, 1, 6);
  const bool is_skewed = one_in(random, 2);
  const auto point = [&] {
    const Rational x = uniform(random, 0, size);
    const Rational y = uniform(random, 0, size);
    return is_skewed ? Point{x / 3 + y / 7, y / 5 - x / 11} : Point{x, y};
  };
  std::vector<Segment> segments(static_cast<std::size_t>(uniform(random, 0, 12)));
  for (Segment& s : segments) {
    s.source = point();
    s.target = point();
  }
  return segments;
}

}  // namespace oplus
