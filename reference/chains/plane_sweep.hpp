// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Points, and edges between two of them, all named by their indices. It refers to the points given to
/// it, which must stay where they are. An edge with equal ends is a point.
struct SweptEdges {
  struct Edge {
    std::uint32_t source, target;
  };

  std::vector<const Point*> points;
  std::vector<Edge> edges;

  void add(const Point& p);
  /// Adds the ends of a segment, and an edge from one to the other.
  void add(const Segment& s);
  /// Adds the vertices, and the edge that leaves each of them: with chains only, both have one index.
  void add(const Chain& chain);

  /// Whether an edge is directed from its lexicographically smaller end.
  bool runs_right(std::uint32_t edge) const {
    return *points[edges[edge].source] < *points[edges[edge].target];
  }
};

/// A point at which edges begin, end, touch, cross, or overlap from there on, or a given point.
///
/// Edges are seen as running from their smaller end to their larger one, so that those to the left of
/// a place go to smaller points, and those to the right to larger ones. "Below" and "above" are those of
/// the plane, turned clockwise by an infinitesimal: below a vertical edge is what is to its right.
struct SweptPlace {
  const Point& point;
  std::span<const std::uint32_t> points;  ///< the given points that are equal to it, sorted
  /// Edges that have a piece directly to the left of it; from the lowest to the highest. Where edges
  /// overlap, the one with the smaller index comes first.
  std::span<const std::uint32_t> left;
  std::span<const std::uint32_t> right;  ///< the same, to the right
  std::optional<std::uint32_t> below;    ///< the edge directly below it, not through it
  std::optional<std::uint32_t> above;
};

/// Whether neither end of an edge is at the place. Requires: the edge is in `left` or `right`.
inline bool passes(const SweptEdges& edges, std::uint32_t edge, const SweptPlace& place) {
  const auto [source, target] = edges.edges[edge];
  return !std::binary_search(place.points.begin(), place.points.end(), source) &&
         !std::binary_search(place.points.begin(), place.points.end(), target);
}

/// Visits all places in lexicographic order, until `visit` returns false. (Bentley and Ottmann: a line
/// from left to right passes over the edges, and a balanced tree has those that it meets, in order.)
/// An edge may be in both `left` and `right`. Any edges may be given: they may cross, touch, overlap,
/// or be equal. Exact; O((n + k) log n) for n points and edges and k pairs of a place and an edge through it.
void sweep(const SweptEdges& edges, const std::function<bool(const SweptPlace&)>& visit);

}  // namespace oplus
