// SPDX-License-Identifier: MIT
#include "checked/operations/union_of.hpp"

#include <utility>

#include "checked/operations/winding_sweep.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

PlanarSet union_of(const Region& region, const std::vector<Segment>& segments,
                   const std::vector<Point>& points) {
  SweptSets sets;
  for (const Component& component : region.components) {
    if (component.outer.empty()) ++sets.around;
    sets.add(component.outer);
    for (const Chain& hole : component.holes)
      if (!OPLUS_MUTANT("unions-fill-holes", "the union of polygons lacks their holes"))
        sets.add(hole);
  }
  sets.points = points;
  for (const Segment& s : segments) {
    if (s.source == s.target)
      sets.points.push_back(s.source);
    else
      sets.segments.push_back(s);
  }
  return closed_set(std::move(sets));
}

}  // namespace oplus
