// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter2/boundary_points.hpp"

#include "properties/statements/chapter2/paths_across.hpp"
#include "properties/statements/places/open_sum.hpp"

namespace oplus {

std::vector<Point> some_boundary_points(const Summands& summands) {
  std::vector<Point> points;
  OpenSum open_sum(summands);
  for (const std::vector<Segment>& path : paths_across(summands)) {
    bool was_inside = false;
    for (const Segment& piece : path) {
      const bool is_inside = open_sum.contains(midpoint(piece.source, piece.target));
      if (is_inside != was_inside) points.push_back(piece.source);
      was_inside = is_inside;
    }
  }
  return points;
}

}  // namespace oplus
