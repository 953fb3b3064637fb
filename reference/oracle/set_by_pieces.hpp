// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// A closed set of the plane by its pieces: a region, which may be unbounded, edges, and points.
struct SetByPieces {
  std::vector<Segment> boundary = {};  ///< of the region, which is to the left
  std::vector<Segment> edges = {};     ///< without inner points of the set beside them
  std::vector<Point> points = {};
  bool is_unbounded = false;  ///< the face around the boundary is part of the region

  bool contains(const Point& p) const;
  /// Those of the boundary and the others.
  std::vector<Segment> all_edges() const;
  /// Ends of edges, and the points.
  std::vector<Point> vertices() const;
};

/// The set of a region, and of the value of a closed set (values.hpp).
SetByPieces set_by_pieces(const Region& region);
SetByPieces set_by_pieces(const PlanarSet& value);

/// A path, with points: the edges of a region's first chain but the last one, and the first vertex of each other
/// chain. Empty where the region has no chain.
SetByPieces path_and_points(const Region& region);

SetByPieces translated(SetByPieces set, const Vector& by);
SetByPieces reflected(SetByPieces set);

/// The vertex-edge sum of two sets: each edge of one moved by each vertex of the other. Inside the cells of
/// its arrangement nothing changes in how a and x - b lie together.
std::vector<Segment> vertex_edge_sum(const SetByPieces& a, const SetByPieces& b);

/// Whether the sets have a point in common. If they have, and it is not all of the plane, then so do the
/// boundary of one and the other set; so an edge meets an edge, or a vertex is in the other set.
bool meet(const SetByPieces& a, const SetByPieces& b);

/// Whether all of a is in b: each face of the arrangement of both that is in a is in b.
/// Requires: a is a region, without edges and points of its own, so the closure of these faces.
bool is_subset(const SetByPieces& a, const SetByPieces& b);

}  // namespace oplus
