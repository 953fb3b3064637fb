// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/sum_boundary.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "checked/collision/isolated_touching_points.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using Halfedge = ConvolutionArrangement::Halfedge;
using Vertex = ConvolutionArrangement::Vertex;

BoundaryFeatures features(const ConvolutionArrangement& arrangement, const SumBoundary& boundary) {
  BoundaryFeatures result;
  for (const Halfedge h : boundary.edges) result.edges.push_back(arrangement.geometry(h));
  for (const Halfedge h : boundary.dangling)
    result.dangling_edges.push_back(arrangement.geometry(h));
  result.isolated_vertices = boundary.isolated_vertices;
  return result;
}

/// Whether segments of three directions meet in a vertex.
bool has_three_directions(const ConvolutionArrangement& arrangement, Vertex v) {
  std::vector<std::pair<std::uint32_t, bool>> strands;  // and whether in their own direction
  const Halfedge first = arrangement.leaving(v);
  Halfedge h = first;
  do {
    for (const Halfedge one : {h, ConvolutionArrangement::twin(h)}) {
      const std::pair candidate{arrangement.strand(one), (one & 1U) == 0};
      if (!arrangement.along(one).empty() &&
          std::find(strands.begin(), strands.end(), candidate) == strands.end())
        strands.push_back(candidate);
    }
    h = arrangement.clockwise(h);
  } while (h != first);
  if (strands.size() < 3) return false;

  std::vector<Vector> directions;
  do {
    for (const Halfedge one : {h, ConvolutionArrangement::twin(h)}) {
      if (arrangement.along(one).empty()) continue;
      const Vector d = direction_of(arrangement.segment(arrangement.along(one)[0]).segment);
      if (std::none_of(directions.begin(), directions.end(),
                       [&](const Vector& known) { return same_direction(known, d); }))
        directions.push_back(d);
    }
    h = arrangement.clockwise(h);
  } while (h != first && directions.size() < 3);
  return directions.size() >= 3 &&
         !OPLUS_MUTANT("three-directions-are-too-few",
                       "isolated vertices are not looked for where three directions meet");
}

}  // namespace

void add_low_dimensional_features(const ConvolutionArrangement& arrangement, const Region& p,
                                  const Region& q,
                                  const std::function<bool(const Point&)>& interiors_meet_at,
                                  SumBoundary& boundary) {
  std::vector<bool> edge_is_on_boundary(arrangement.edge_count(), false);
  std::vector<bool> vertex_is_on_feature(arrangement.vertex_count(), false);
  const auto mark = [&](Halfedge h) {
    vertex_is_on_feature[arrangement.source(h)] = true;
    vertex_is_on_feature[arrangement.target(h)] = true;
  };
  for (const Halfedge h : boundary.edges) {
    edge_is_on_boundary[h / 2] = true;
    mark(h);
  }
  for (Halfedge h = 0; h < 2 * arrangement.edge_count(); h += 2) {
    const bool opposite_segments =
        !arrangement.along(h).empty() &&
        !arrangement.along(ConvolutionArrangement::twin(h)).empty() &&
        !OPLUS_MUTANT("dangling-edges-run-one-way",
                      "dangling edges are not looked for where opposite segments overlap");
    if (edge_is_on_boundary[h / 2] || !opposite_segments) continue;
    const Segment edge = arrangement.geometry(h);
    if (OPLUS_MUTANT("vertical-edges-never-dangle",
                     "dangling edges are not looked for where they are parallel to the y-axis") &&
        edge.source.x == edge.target.x)
      continue;
    if (interiors_meet_at(midpoint(edge.source, edge.target))) continue;
    boundary.dangling.push_back(h);
    mark(h);
  }
  for (Vertex v = 0; v < arrangement.vertex_count(); ++v) {
    if (vertex_is_on_feature[v] || !has_three_directions(arrangement, v)) continue;
    const Point x = arrangement.point(v);
    if (!interiors_meet_at(x)) boundary.isolated_vertices.push_back(x);
  }
  const auto found = [&] { return sum_within(arrangement, boundary); };
  for (Point& x : isolated_touching_points(p, q, interiors_meet_at, found))
    boundary.isolated_vertices.push_back(std::move(x));
}

PlanarSet sum_within(const ConvolutionArrangement& arrangement, const SumBoundary& boundary) {
  return canonical_sum(features(arrangement, boundary));
}

Origins origins_of(const PlanarSet& sum, const ConvolutionArrangement& arrangement,
                   const SumBoundary& boundary) {
  /// An edge of the arrangement on the sum's boundary.
  struct Piece {
    Segment edge;
    std::set<Origin> origins;
  };
  std::multimap<Point, Piece> pieces;  // by their sources
  const auto add = [&](Segment edge, std::initializer_list<Halfedge> halfedges) {
    Piece piece{std::move(edge), {}};
    for (const Halfedge h : halfedges) {
      for (const std::uint32_t i : arrangement.along(h)) {
        const ConvolutionSegment& s = arrangement.segment(i);
        if (!s.vertex_is_reflex) piece.origins.insert(s.origin);
      }
    }
    pieces.emplace(piece.edge.source, std::move(piece));
  };
  // On the regularized boundary all origins run along the edge; on a dangling edge, either way.
  for (const Halfedge h : boundary.edges) add(arrangement.geometry(h), {h});
  for (const Halfedge h : boundary.dangling) {
    Segment edge = arrangement.geometry(h);
    if (edge.target < edge.source) edge = reversed(edge);
    add(std::move(edge), {h, ConvolutionArrangement::twin(h)});
  }

  Origins result;
  for (const Segment& edge : edges(sum)) {
    std::set<Origin> origins;
    for (Point at = edge.source; at != edge.target;) {
      const auto [begin, end] = pieces.equal_range(at);
      const auto piece = std::find_if(begin, end, [&](const auto& candidate) {
        return same_direction(direction_of(candidate.second.edge), direction_of(edge));
      });
      OPLUS_ENSURES(piece != end, "Theorem 2.3.2");
      origins.insert(piece->second.origins.begin(), piece->second.origins.end());
      at = piece->second.edge.target;
    }
    result.emplace_back(origins.begin(), origins.end());
  }
  return result;
}

}  // namespace oplus
