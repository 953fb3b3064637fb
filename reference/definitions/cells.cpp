// SPDX-License-Identifier: MIT
#include "reference/definitions/cells.hpp"

#include <algorithm>
#include <utility>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/ray.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

/// The edges, once in each direction: halfedge 2e runs along edge e, from its smaller end, and 2e + 1
/// back. A walk goes from a halfedge to the next one of the boundary of the face to its left.
class Halfedges {
 public:
  explicit Halfedges(const Cells& cells)
      : cells_(cells), leaving_(cells.vertices.size()), next_(2 * cells.edges.size()) {
    for (std::size_t h = 0; h < next_.size(); ++h) leaving_[source(h)].push_back(h);
    for (std::vector<std::size_t>& around : leaving_) {
      std::sort(around.begin(), around.end(),
                [&](std::size_t g, std::size_t h) { return is_before(g, h); });
      // At its end a walk turns clockwise from where it came from.
      for (std::size_t i = 0; i < around.size(); ++i)
        next_[twin(around[i])] = around[(i + around.size() - 1) % around.size()];
    }
  }

  static std::size_t twin(std::size_t h) { return h ^ 1; }
  static bool is_to_the_right(std::size_t h) { return h % 2 == 0; }
  std::size_t size() const { return next_.size(); }
  std::size_t source(std::size_t h) const {
    const Cells::Edge& e = cells_.edges[h / 2];
    return is_to_the_right(h) ? e.source : e.target;
  }
  Segment segment(std::size_t h) const {
    const Segment& s = cells_.edges[h / 2].segment;
    return is_to_the_right(h) ? s : reversed(s);
  }
  std::size_t next(std::size_t h) const { return next_[h]; }
  const std::vector<std::size_t>& leaving(std::size_t vertex) const { return leaving_[vertex]; }

 private:
  /// Counterclockwise around a vertex, from straight down, which itself is last: first those to larger
  /// points, in lexicographic order, then those to smaller ones. Either are less than half a turn.
  bool is_before(std::size_t g, std::size_t h) const {
    if (is_to_the_right(g) != is_to_the_right(h)) return is_to_the_right(g);
    return orientation(cells_.vertices[source(g)], cells_.vertices[source(twin(g))],
                       cells_.vertices[source(twin(h))]) > 0;
  }

  const Cells& cells_;
  std::vector<std::vector<std::size_t>> leaving_;
  std::vector<std::size_t> next_;
};

/// Finds the edge directly below the points that are infinitely near to a vertex, to its left.
class BelowVertices {
 public:
  explicit BelowVertices(const Cells& cells) : cells_(cells) {
    for (std::size_t v = 0; v < cells.vertices.size(); ++v)
      column_.push_back(v == 0 ? 0
                               : column_.back() + (cells.vertices[v - 1].x < cells.vertices[v].x));
  }

  /// Requires: no edge has its larger end at the vertex.
  std::optional<std::size_t> below(std::size_t vertex) const {
    std::optional<std::size_t> highest;
    for (std::size_t i = 0; i < cells_.edges.size(); ++i) {
      const Cells::Edge& e = cells_.edges[i];
      if (column_[e.source] >= column_[vertex]) break;  // edges are sorted
      if (column_[e.target] < column_[vertex]) continue;
      if (is_below(e.segment, cells_.vertices[vertex]) &&
          (!highest || is_above(e.segment, cells_.edges[*highest].segment)))
        highest = i;
    }
    return highest;
  }

 private:
  static bool is_below(const Segment& s, const Point& p) {
    return orientation(s.source, s.target, p) > 0;
  }

  /// Of two segments that do not cross and have both a point on some vertical line. Requires: t does not start after s.
  static bool is_above(const Segment& s, const Segment& t) {
    const int side = orientation(t.source, t.target, s.source);
    return side != 0 ? side > 0 : orientation(t.source, t.target, s.target) > 0;
  }

  const Cells& cells_;
  std::vector<std::size_t> column_;  ///< of each vertex: how many smaller x there are
};

}  // namespace

Cells cells(const std::vector<Segment>& segments) {
  return cells_of_pieces(cut_at_intersections(segments));
}

Cells cells_of_pieces(const std::vector<std::vector<Segment>>& pieces) {
  return cells_of_pieces(pieces, [](const Cells& cells) {
    std::vector<bool> is_larger_end(cells.vertices.size(), false);
    for (const Cells::Edge& e : cells.edges) is_larger_end[e.target] = true;
    const BelowVertices below(cells);
    EdgesBelow result(cells.vertices.size());
    for (std::size_t v = 0; v < result.size(); ++v)
      if (!is_larger_end[v]) result[v] = below.below(v);
    return result;
  });
}

Cells cells_of_pieces(const std::vector<std::vector<Segment>>& pieces,
                      const std::function<EdgesBelow(const Cells&)>& edges_below) {
  std::vector<Segment> edges;
  Cells result;
  for (const std::vector<Segment>& of_segment : pieces) {
    for (const Segment& piece : of_segment) {
      edges.push_back(piece.source < piece.target ? piece : reversed(piece));
      result.vertices.push_back(piece.source);
      result.vertices.push_back(piece.target);
    }
  }
  result.vertices = sorted_without_copies(std::move(result.vertices));
  const auto number = [&](const Point& p) {
    return static_cast<std::size_t>(
        std::lower_bound(result.vertices.begin(), result.vertices.end(), p) -
        result.vertices.begin());
  };
  for (Segment& s : sorted_without_copies(std::move(edges))) {
    const std::size_t source = number(s.source), target = number(s.target);
    result.edges.push_back({std::move(s), 0, 0, source, target});
  }

  const Halfedges halfedges(result);
  const EdgesBelow below = edges_below(result);
  result.faces.resize(1);
  std::vector<bool> is_walked(halfedges.size(), false);
  const auto walk = [&](std::size_t first, std::size_t face) {
    std::size_t h = first;
    do {
      is_walked[h] = true;
      result.faces[face].push_back(halfedges.segment(h));
      Cells::Edge& e = result.edges[h / 2];
      (Halfedges::is_to_the_right(h) ? e.left_face : e.right_face) = face;
    } while ((h = halfedges.next(h)) != first);
  };
  // Each walk starts at its smallest vertex. The walk around connected edges, from outside, passes to
  // the left of that; the outer boundary of a face is to the right of it. Vertices are sorted, so that
  // the walks of all edges to the left are known.
  for (std::size_t v = 0; v < result.vertices.size(); ++v) {
    const std::size_t last = halfedges.leaving(v).back();
    if (Halfedges::is_to_the_right(last) && !is_walked[last]) {
      walk(last, below[v] ? result.edges[*below[v]].left_face : 0);
    }
    for (const std::size_t h : halfedges.leaving(v)) {
      if (!Halfedges::is_to_the_right(h) || is_walked[h]) continue;
      result.faces.emplace_back();
      walk(h, result.faces.size() - 1);
    }
  }
  return result;
}

Point point_inside(const std::vector<Segment>& boundary) {
  const Vector along = direction_of(boundary[0]);
  return point_beside(midpoint(boundary[0].source, boundary[0].target), {-along.y, along.x},
                      boundary);
}

}  // namespace oplus
