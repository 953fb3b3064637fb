// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/laws/linear_map.hpp"

#include <algorithm>

namespace oplus {

namespace {

Chain image(const LinearMap& map, Chain chain) {
  for (Point& p : chain) p = map(p);
  if (sign(map.determinant()) < 0) std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

LinearMap scaling(const Rational& factor) { return {factor, 0, 0, factor}; }

Region image(const LinearMap& map, const Region& region) {
  Region result;
  for (const Component& component : region.components) {
    result.components.push_back({image(map, component.outer), {}});
    for (const Chain& hole : component.holes)
      result.components.back().holes.push_back(image(map, hole));
  }
  return result;
}

MinkowskiSum image(const LinearMap& map, const MinkowskiSum& sum, const Vector& by) {
  const auto of_segment = [&](const Segment& s) {
    return Segment{map(s.source) + by, map(s.target) + by};
  };
  // Chains may touch edges in their middle; features meet at ends only.
  const std::vector<Segment> boundary = edges(MinkowskiSum{sum.outer, sum.holes, {}, {}});
  std::vector<Point> vertices;
  for (const Segment& edge : boundary) vertices.push_back(edge.source);
  BoundaryFeatures features;
  for (const Segment& edge : boundary) {
    for (const Segment& piece : cut(edge, vertices)) {
      const Segment mapped = of_segment(piece);
      features.edges.push_back(sign(map.determinant()) < 0 ? reversed(mapped) : mapped);
    }
  }
  for (const Segment& s : sum.dangling_edges) features.dangling_edges.push_back(of_segment(s));
  for (const Point& p : sum.isolated_vertices) features.isolated_vertices.push_back(map(p) + by);
  return canonical_sum(features);
}

}  // namespace oplus
