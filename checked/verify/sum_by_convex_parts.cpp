// SPDX-License-Identifier: MIT
#include "checked/verify/sum_by_convex_parts.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "checked/verify/convex_sums.hpp"
#include "reference/chains/plane_sweep.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

/// Cuts edges where others end, so that they meet at common ends only, and leaves out copies; leaves
/// out isolated vertices that are on an edge.
void cut_at_ends(BoundaryFeatures& features) {
  const std::vector<Segment>& whole = features.edges;
  SweptEdges swept;
  for (const Segment& edge : whole) swept.add(edge);
  for (const Segment& edge : features.dangling_edges) swept.add(edge);
  for (const Point& point : features.isolated_vertices) swept.add(point);

  std::vector<Point> places;
  places.reserve(whole.size());
  std::vector<std::size_t> begin(
      swept.edges.size());  // of the piece of an edge that is passed over
  std::vector<std::pair<std::size_t, std::size_t>> pieces;
  std::vector<Point> isolated;
  sweep(swept, [&](const SweptPlace& place) {
    for (const std::uint32_t edge : place.left) {
      if (edge >= whole.size()) continue;
      pieces.emplace_back(begin[edge], places.size());
      if (!swept.runs_right(edge)) std::swap(pieces.back().first, pieces.back().second);
    }
    for (const std::uint32_t edge : place.right) begin[edge] = places.size();
    places.push_back(place.point);
    if (place.left.empty() && place.right.empty()) isolated.push_back(place.point);
    return true;
  });
  features.isolated_vertices = std::move(isolated);
  pieces = sorted_without_copies(std::move(pieces));
  features.edges.clear();
  features.edges.reserve(pieces.size());
  for (const auto& [source, target] : pieces)
    features.edges.push_back({places[source], places[target]});
}

std::vector<std::size_t> starting_at(const std::vector<Segment>& edges,
                                     const std::vector<Point>& points) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (std::binary_search(points.begin(), points.end(), edges[i].source)) result.push_back(i);
  return result;
}

/// Where no segment of the reduced convolution may pass (docs/findings.md, Theorem 2.3.2).
void add_sums_of_touching_points(const Region& p, const Region& q, ConvexSums& sums,
                                 std::vector<Point>& outside) {
  const std::vector<Point> touching_p = touching_points(p);
  if (touching_p.empty()) return;
  const std::vector<std::size_t> of_p = starting_at(edges(p), touching_p);
  const std::vector<std::size_t> of_q = starting_at(edges(q), touching_points(q));
  for (const std::size_t e : of_p) {
    for (const std::size_t v : of_q) {
      const ConvexSums::EdgeAtVertex candidate{Summand::P, e, v};
      if (sums.source_is_outside(candidate)) outside.push_back(sums.segment(candidate).source);
    }
  }
}

}  // namespace

PlanarSet sum_by_convex_parts(const Region& p, const Region& q, Boundary boundary) {
  ConvexSums sums(p, q);
  BoundaryFeatures features;
  for (const ConvexSums::EdgeAtVertex& candidate : sums.reduced_convolution()) {
    if (boundary == Boundary::closed) {
      for (Segment& s : sums.boundary_parts(candidate)) features.edges.push_back(std::move(s));
      continue;
    }
    ConvexSums::Outside outside = sums.outside_parts(candidate);
    features.edges.insert(features.edges.end(), outside.boundary.begin(), outside.boundary.end());
    for (Segment& s : outside.inside_closed_sum) {
      if (s.target < s.source) swap(s.source, s.target);
      features.dangling_edges.push_back(std::move(s));
    }
    features.isolated_vertices.insert(features.isolated_vertices.end(), outside.points.begin(),
                                      outside.points.end());
  }
  if (boundary == Boundary::open)
    add_sums_of_touching_points(p, q, sums, features.isolated_vertices);

  cut_at_ends(features);
  return canonical_sum(features);
}

}  // namespace oplus
