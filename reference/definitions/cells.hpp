// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// The arrangement of segments: what they cut the plane into. Vertices are in lexicographic order,
/// edges too, and faces in that of their smallest vertices, the unbounded one first.
struct Cells {
  struct Edge {
    Segment segment;
    std::size_t left_face, right_face;
    std::size_t source, target;  ///< vertices
  };

  /// The boundary of each face, the face to the left of each segment; an edge with the face on both
  /// sides is there twice. The outer boundary comes first, then those of holes. Without any segment the
  /// plane is one face without a boundary.
  std::vector<std::vector<Segment>> faces;
  std::vector<Edge> edges;  ///< each directed from its smaller end
  std::vector<Point> vertices;
  std::size_t unbounded_face = 0;
};

/// All pairs of segments are cut where they meet; then walks around the pieces find the faces. O(n²).
Cells cells(const std::vector<Segment>& segments);

/// The same of segments that are cut already.
/// Requires: `pieces` as cut_at_intersections returns them.
Cells cells_of_pieces(const std::vector<std::vector<Segment>>& pieces);

/// For each vertex that is no edge's larger end, an edge that has on its left the face that is to the left of
/// the vertex; empty where that is the unbounded face.
using EdgesBelow = std::vector<std::optional<std::size_t>>;

/// The same, where a function finds these edges, given vertices and edges: O(n log n) besides.
Cells cells_of_pieces(const std::vector<std::vector<Segment>>& pieces,
                      const std::function<EdgesBelow(const Cells&)>& edges_below);

/// A point inside a face: from the middle of its first edge to the left, half way to what is met
/// first. Requires: the boundary is not empty.
Point point_inside(const std::vector<Segment>& boundary);

}  // namespace oplus
