// SPDX-License-Identifier: MIT
#include "checked/pieces/triangulation.hpp"

#include <cmath>
#include <map>

#include "reference/definitions/mutant.hpp"

namespace oplus::pieces {

namespace {

using Index = std::uint32_t;
constexpr Index none = Triangulation::none;

/// The gap between two edges that are neighbours on the line of a sweep, inside the region, has a front: a chain of
/// vertices from the start of the lower edge to that of the upper one, through what the line has passed
/// between them. Up to the front all is triangulated; seen from the line, no corner of it is convex, so that
/// what is between the two edges can be added as triangles as soon as both end. Before its newest vertex it
/// runs to the right, behind it to the left.
class Triangulator {
 public:
  Triangulator(const SweptEdges& boundary, std::span<const NearPoint> vertices)
      : boundary_(boundary), vertices_(vertices), fronts_(boundary.edges.size()) {
    for (const auto& [source, target] : boundary.edges)
      runs_right_.push_back(compare(vertices[source], vertices[target]) < 0);
  }

  Triangulation made() && {
    sweep(boundary_, [&](const SweptPlace& place) {
      pass(place);
      return true;
    });
    for (auto& [edge, points] : points_in_) {
      if (!runs_right_[edge]) std::ranges::reverse(points);
      for (Point& point : points) made_.points.push_back({edge, std::move(point)});
    }
    return std::move(made_);
  }

 private:
  /// A vertex of a front, and what is to the left of the front's edge that leaves it: an edge of a triangle,
  /// none at an edge of the region, or, of a diagonal without triangles so far, its number after `waiting`.
  struct Node {
    Index vertex, previous, next;
    Index behind;
  };
  struct Front {
    Index bottom, newest, top;
  };
  static constexpr Index waiting = Index{1} << 31;

  void pass(const SweptPlace& place) {
    const Index vertex = place.points.front();
    for (const Index edge : place.left)
      if (passes(boundary_, edge, place)) points_in_[edge].push_back(place.point);

    // What is between the place and the edges directly below and above it.
    Front lower{}, upper{};
    const bool is_inside_below = place.below && runs_right_[*place.below];
    if (place.left.empty()) {
      if (is_inside_below) {
        lower = fronts_[*place.below];
        upper = split(lower);
        const Index diagonal = waiting | static_cast<Index>(waiting_.size());
        waiting_.push_back(none);
        append(lower, vertex, diagonal);
        prepend(upper, vertex, diagonal);
        if (OPLUS_MUTANT("triangles-end-where-edges-do",
                         "verify loses triangles to the left of a vertex at which no edge ends")) {
          lower.bottom = lower.top;
          nodes_[lower.top].previous = none;
        }
      }
    } else {
      if (is_inside_below) {
        lower = fronts_[*place.below];
        append(lower, vertex, none);
      }
      for (const Index edge : place.left) {
        if (!runs_right_[edge]) continue;
        Front& front = fronts_[edge];
        if (edge == place.left.back())
          prepend(upper = front, vertex, none);
        else
          append(front, vertex, none);
      }
    }

    if (place.right.empty()) {
      if (is_inside_below) fronts_[*place.below] = joined(lower, upper);
      return;
    }
    if (is_inside_below) fronts_[*place.below] = lower;
    for (const Index edge : place.right) {
      if (!runs_right_[edge]) continue;
      if (edge == place.right.back()) {
        fronts_[edge] = upper;
      } else {
        const Index node = added({vertex, none, none, none});
        fronts_[edge] = {node, node, node};
      }
    }
  }

  Index added(const Node& node) {
    nodes_.push_back(node);
    return static_cast<Index>(nodes_.size() - 1);
  }

  /// Takes away what follows the newest vertex, which both have then.
  Front split(Front& front) {
    Node& newest = nodes_[front.newest];
    const Index copy = added({newest.vertex, none, newest.next, newest.behind});
    nodes_[front.newest].next = none;
    Front rest{copy, copy, front.top};
    if (front.top == front.newest)
      rest.top = copy;
    else
      nodes_[nodes_[copy].next].previous = copy;
    front.top = front.newest;
    return rest;
  }

  /// Two that have the newest vertex in common.
  Front joined(const Front& lower, const Front& upper) {
    Node& newest = nodes_[lower.top];
    newest.next = nodes_[upper.bottom].next;
    newest.behind = nodes_[upper.bottom].behind;
    nodes_[newest.next].previous = lower.top;
    return {lower.bottom, lower.top, upper.top};
  }

  void append(Front& front, Index vertex, Index behind) {
    Index last = front.top;
    for (Index a = nodes_[last].previous; a != none; a = nodes_[last].previous) {
      const Index e = add_triangle(nodes_[a].vertex, vertex, nodes_[last].vertex);
      if (e == none) break;
      join(e + 1, behind);
      join(e + 2, nodes_[a].behind);
      behind = e;
      last = a;
    }
    const Index node = added({vertex, last, none, none});
    nodes_[last].next = node;
    nodes_[last].behind = behind;
    front.newest = front.top = node;
  }

  void prepend(Front& front, Index vertex, Index behind) {
    Index first = front.bottom;
    for (Index b = nodes_[first].next; b != none; b = nodes_[first].next) {
      const Index e = add_triangle(nodes_[first].vertex, vertex, nodes_[b].vertex);
      if (e == none) break;
      join(e, behind);
      join(e + 2, nodes_[first].behind);
      behind = e + 1;
      first = b;
    }
    const Index node = added({vertex, none, first, behind});
    nodes_[first].previous = node;
    front.newest = front.bottom = node;
  }

  /// Its first edge; none where the corners are not counterclockwise.
  Index add_triangle(Index a, Index b, Index c) {
    if (orientation(vertices_[a], vertices_[b], vertices_[c]) <= 0) return none;
    const auto first = static_cast<Index>(made_.sources.size());
    for (const Index corner : {a, b, c}) made_.sources.push_back(corner);
    made_.twins.resize(made_.sources.size(), none);
    return first;
  }

  void join(Index edge, Index behind) {
    if (behind == none) return;
    if ((behind & waiting) != 0) {
      Index& other = waiting_[behind & ~waiting];
      if (other == none) {
        other = edge;
        return;
      }
      behind = other;
    }
    made_.twins[edge] = behind;
    made_.twins[behind] = edge;
  }

  const SweptEdges& boundary_;
  const std::span<const NearPoint> vertices_;
  std::vector<bool> runs_right_;  ///< of edges
  std::vector<Front> fronts_;     ///< of the gaps above edges
  std::vector<Node> nodes_;
  std::vector<Index>
      waiting_;  ///< of diagonals without triangles at first, an edge along the first one
  std::map<Index, std::vector<Point>> points_in_;
  Triangulation made_;
};

/// Whether the last of four places is certainly inside the circle through the others, which are counterclockwise.
/// The bound is Shewchuk's (Adaptive precision floating-point arithmetic, 1997), and what products that are too small
/// for doubles lose, of places up to 2^100.
bool is_in_circle(const Place& a, const Place& b, const Place& c, const Place& d) {
  constexpr double lost = 0x1p-850;
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double determinant =
      a2 * (bx * cy - by * cx) + b2 * (cx * ay - cy * ax) + c2 * (ax * by - ay * bx);
  const double size = a2 * (std::abs(bx * cy) + std::abs(by * cx)) +
                      b2 * (std::abs(cx * ay) + std::abs(cy * ax)) +
                      c2 * (std::abs(ax * by) + std::abs(ay * bx));
  return determinant > 0x1p-49 * size + lost;
}

/// Lawson's flips. Each makes the volume below the triangles smaller when places are lifted to a paraboloid, so
/// they end, in whatever order; exact numbers decide whether what a flip makes are triangles.
class Flips {
 public:
  Flips(Triangulation& of, std::span<const NearPoint> vertices, std::span<const Place> places)
      : sources_(of.sources), twins_(of.twins), vertices_(vertices), places_(places) {}

  void run() {
    for (Index e = 0; e < twins_.size(); ++e) {
      open_.push_back(e);
      while (!open_.empty()) {
        const Index edge = open_.back();
        open_.pop_back();
        if (twins_[edge] != none && is_to_be_flipped(edge)) flip(edge);
      }
    }
  }

 private:
  static Index next(Index e) { return Triangulation::next(e); }
  static Index previous(Index e) { return Triangulation::previous(e); }

  bool is_to_be_flipped(Index e) const {
    const Index a = sources_[e], b = sources_[next(e)], left = sources_[previous(e)];
    const Index right = sources_[previous(twins_[e])];
    return is_in_circle(places_[a], places_[b], places_[left], places_[right]) &&
           orientation(vertices_[right], vertices_[b], vertices_[left]) > 0 &&
           orientation(vertices_[left], vertices_[a], vertices_[right]) > 0;
  }

  void flip(Index e) {
    const Index f = twins_[e];
    const Index after_e = next(e), before_e = previous(e), after_f = next(f),
                before_f = previous(f);
    sources_[e] = sources_[before_f];
    sources_[f] = sources_[before_e];
    join(e, twins_[before_f]);
    join(f, twins_[before_e]);
    join(before_e, before_f);
    for (const Index around : {e, after_e, f, after_f}) open_.push_back(around);
  }

  void join(Index e, Index f) {
    twins_[e] = f;
    if (f != none) twins_[f] = e;
  }

  std::vector<Index>& sources_;
  std::vector<Index>& twins_;
  const std::span<const NearPoint> vertices_;
  const std::span<const Place> places_;
  std::vector<Index> open_;
};

}  // namespace

Triangulation triangulation(const SweptEdges& boundary, std::span<const NearPoint> vertices,
                            std::span<const Place> places) {
  Triangulation result = Triangulator(boundary, vertices).made();
  Flips(result, vertices, places).run();
  return result;
}

}  // namespace oplus::pieces
