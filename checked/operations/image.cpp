// SPDX-License-Identifier: MIT
#include "checked/operations/image.hpp"

#include <utility>

#include "reference/chains/region_of.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

AffineMap scaled_by(const Rational& factor) { return {factor, 0, 0, factor}; }

Region image(const AffineMap& map, Region region) {
  OPLUS_REQUIRES(map.determinant() != 0, "image");
  Region result = mapped(std::move(region), map);
  if (sign(map.determinant()) < 0 &&
      !OPLUS_MUTANT("mirrored-chains-keep-their-order",
                    "maps that exchange left and right leave the interior on the right of edges")) {
    for (Component& component : result.components) {
      component.outer = turned(std::move(component.outer));
      for (Chain& hole : component.holes) hole = turned(std::move(hole));
    }
  }
  return result;
}

PlanarSet image(const AffineMap& map, const PlanarSet& sum) {
  // By way of a region, as maps that exchange left and right change which way chains turn where they touch.
  PlanarSet result = canonical_sum(image(map, region_of(sum)));
  BoundaryFeatures features;
  for (const Segment& s : sum.dangling_edges)
    features.dangling_edges.push_back({map(s.source), map(s.target)});
  for (const Point& p : sum.isolated_vertices) features.isolated_vertices.push_back(map(p));
  PlanarSet low = canonical_sum(features);
  result.dangling_edges = std::move(low.dangling_edges);
  result.isolated_vertices = std::move(low.isolated_vertices);
  return result;
}

}  // namespace oplus
