// SPDX-License-Identifier: MIT
#include "checked/verify/trapezoids.hpp"

#include "reference/chains/plane_sweep.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

std::vector<Trapezoid> trapezoids(const Region& region) {
  SweptEdges swept;
  for (const Component& component : region.components) {
    swept.add(component.outer);
    for (const Chain& hole : component.holes) swept.add(hole);
  }
  std::vector<Trapezoid> result;
  std::vector<std::uint32_t> wall_of(swept.edges.size());  // where the gap above an edge began
  sweep(swept, [&](const SweptPlace& place) {
    const std::uint32_t vertex = place.points.front();
    // The gaps that end here, between neighbours from below to above.
    std::optional<std::uint32_t> lower = place.below;
    const auto close = [&](std::uint32_t upper) {
      if (lower && swept.runs_right(*lower) &&
          swept.points[wall_of[*lower]]->x != swept.points[vertex]->x)
        result.push_back({*lower, upper, wall_of[*lower], vertex});
      lower = upper;
    };
    for (const std::uint32_t edge : place.left) close(edge);
    if (place.above) close(*place.above);
    if (place.below &&
        !OPLUS_MUTANT("trapezoids-pass-through-walls",
                      "a trapezoid of verify begins where the gap above its lower edge "
                      "did, before a vertex that divided the gap"))
      wall_of[*place.below] = vertex;
    for (const std::uint32_t edge : place.right) wall_of[edge] = vertex;
    return true;
  });
  return result;
}

}  // namespace oplus
