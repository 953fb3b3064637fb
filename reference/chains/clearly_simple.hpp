// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "reference/chains/near_point.hpp"

namespace oplus {

/// Whether doubles tell that a closed chain is simple: that its edges meet in the vertices that they share, and nowhere
/// else. Never of a long one, which a sweep takes less time for.
inline bool is_clearly_simple(std::span<const NearPoint> chain) {
  constexpr std::size_t most_edges = 24;
  const std::size_t n = chain.size();
  if (n < 3 || n > most_edges) return false;
  struct Box {
    double low_x, low_y, high_x, high_y;
  };
  std::array<Box, most_edges> boxes;
  const auto target = [&](std::size_t i) -> const IntervalPoint& {
    return chain[i + 1 == n ? 0 : i + 1].near;
  };
  const auto are_on_one_side = [&](std::size_t of, std::size_t i) {
    const int source = orientation_in_doubles(chain[of].near, target(of), chain[i].near);
    return source != 0 && source == orientation_in_doubles(chain[of].near, target(of), target(i));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const IntervalPoint &a = chain[i].near, &b = target(i);
    if (orientation_in_doubles(a, b, target(i + 1 == n ? 0 : i + 1)) == 0) return false;
    boxes[i] = {std::min(a.x.low, b.x.low), std::min(a.y.low, b.y.low),
                std::max(a.x.high, b.x.high), std::max(a.y.high, b.y.high)};
  }
  for (std::size_t i = 2; i < n; ++i)
    for (std::size_t j = i + 1 == n ? 1 : 0; j + 1 < i; ++j) {
      const Box &a = boxes[i], &b = boxes[j];
      const bool are_apart =
          a.high_x < b.low_x || b.high_x < a.low_x || a.high_y < b.low_y || b.high_y < a.low_y;
      if (!are_apart && !are_on_one_side(i, j) && !are_on_one_side(j, i)) return false;
    }
  return true;
}

}  // namespace oplus
