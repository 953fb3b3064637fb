// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/region.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// Q at places where it overlaps P, touches it in a vertex, or is apart from it: as it is; with each of so many vertices
/// at one of P; beside one of these by less than the grid; and far away in two directions.
inline std::vector<Region> places_of_q(const Summands& pair, std::size_t vertices) {
  std::vector<Region> all = {pair.q, translated(pair.q, {40, 3}), translated(pair.q, {-7, -40})};
  const std::vector<Segment> of_p = edges(pair.p), of_q = edges(pair.q);
  for (std::size_t i = 0; i < vertices; ++i) {
    const Vector by = of_p[i * of_p.size() / vertices].source -
                      of_q[(vertices - 1 - i) * of_q.size() / vertices].source;
    all.push_back(translated(pair.q, by));
    all.push_back(translated(pair.q, by + Vector{Rational(1, 3), Rational(-1, 5)}));
  }
  return all;
}

}  // namespace oplus
