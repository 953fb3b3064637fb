// SPDX-License-Identifier: MIT
#include "reference/definitions/winding_number.hpp"

#include "reference/definitions/mutant.hpp"

namespace oplus {

int winding_number(const Point& p, const std::vector<Segment>& segments) {
  int crossings = 0;
  for (const Segment& s : segments) {
    const bool source_below =
        OPLUS_MUTANT("ray-counts-both-ends",
                     "a ray through a vertex counts both edges that meet there")
            ? s.source.y < p.y
            : s.source.y <= p.y;
    const bool target_below = s.target.y <= p.y;
    if (source_below == target_below) continue;
    const int side = orientation(s.source, s.target, p);
    if (source_below && side > 0) ++crossings;
    if (target_below && side < 0) --crossings;
  }
  return crossings;
}

}  // namespace oplus
