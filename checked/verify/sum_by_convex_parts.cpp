// SPDX-License-Identifier: MIT
#include "checked/verify/sum_by_convex_parts.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

#include "checked/verify/convex_sums.hpp"
#include "reference/chains/plane_sweep.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

/// Features in which edges may overlap. Without room for more, which a vector would have.
struct Pieces {
  std::deque<Segment> edges;
  std::deque<Segment> dangling_edges;
  std::vector<Point> isolated_vertices;
};

/// Cuts edges where others end, so that they meet at common ends only, and leaves out copies; leaves
/// out isolated vertices that are on an edge.
BoundaryFeatures cut_at_ends(Pieces features) {
  const std::deque<Segment>& whole = features.edges;
  SweptEdges swept;
  for (const Segment& edge : whole) swept.add(edge);
  for (const Segment& edge : features.dangling_edges) swept.add(edge);
  for (const Point& point : features.isolated_vertices) swept.add(point);

  std::vector<Point> places;
  places.reserve(whole.size());
  std::vector<std::uint32_t> begin(
      swept.edges.size());  // of the piece of an edge that is passed over
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces;
  BoundaryFeatures result;
  sweep(swept, [&](const SweptPlace& place) {
    const auto here = static_cast<std::uint32_t>(places.size());
    for (const std::uint32_t edge : place.left) {
      if (edge >= whole.size()) continue;
      pieces.emplace_back(begin[edge], here);
      if (!swept.runs_right(edge)) std::swap(pieces.back().first, pieces.back().second);
    }
    for (const std::uint32_t edge : place.right) begin[edge] = here;
    places.push_back(place.point);
    if (place.left.empty() && place.right.empty()) result.isolated_vertices.push_back(place.point);
    return true;
  });
  result.dangling_edges.assign(std::make_move_iterator(features.dangling_edges.begin()),
                               std::make_move_iterator(features.dangling_edges.end()));
  features = {};
  pieces = sorted_without_copies(std::move(pieces));
  result.edges.reserve(pieces.size());
  for (const auto& [source, target] : pieces)
    result.edges.push_back({places[source], places[target]});
  return result;
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

Pieces pieces_of_sum(const Region& p, const Region& q, Boundary boundary) {
  ConvexSums sums(p, q);
  Pieces result;
  const auto add = [](std::deque<Segment>& to, std::vector<Segment>& segments) {
    std::ranges::move(segments, std::back_inserter(to));
  };
  for (const ConvexSums::EdgeAtVertex& candidate : sums.reduced_convolution()) {
    if (boundary == Boundary::closed) {
      std::vector<Segment> parts = sums.boundary_parts(candidate);
      add(result.edges, parts);
      continue;
    }
    ConvexSums::Outside outside = sums.outside_parts(candidate);
    add(result.edges, outside.boundary);
    for (Segment& s : outside.inside_closed_sum)
      if (s.target < s.source) swap(s.source, s.target);
    add(result.dangling_edges, outside.inside_closed_sum);
    std::ranges::move(outside.points, std::back_inserter(result.isolated_vertices));
  }
  if (boundary == Boundary::open) add_sums_of_touching_points(p, q, sums, result.isolated_vertices);
  return result;
}

}  // namespace

PlanarSet sum_by_convex_parts(const Region& p, const Region& q, Boundary boundary) {
  return canonical_sum(cut_at_ends(pieces_of_sum(p, q, boundary)));
}

}  // namespace oplus
