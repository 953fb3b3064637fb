// SPDX-License-Identifier: MIT
#include "checked/verify/trapezoids.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

#include "reference/arithmetic/interval.hpp"

namespace oplus {

namespace {

/// Points are passed in lexicographic order, as if the plane were sheared a little: so vertical edges
/// need no rule of their own, and trapezoids without width are left out.
class Sweep {
 public:
  explicit Sweep(const std::vector<Segment>& edges)
      : edges_(edges), status_(Below{this}), wall_of_(edges.size()) {
    for (const Segment& e : edges) {
      near_.push_back(interval(e));
      to_the_right_.push_back(e.source < e.target);
    }
  }

  std::vector<Trapezoid> sweep() {
    std::vector<std::size_t> starts(edges_.size());  // edges by their left ends
    std::iota(starts.begin(), starts.end(), 0);
    std::vector<std::size_t> vertices = starts;  // named by the edges that start there
    std::sort(starts.begin(), starts.end(),
              [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
    std::sort(vertices.begin(), vertices.end(), [&](std::size_t a, std::size_t b) {
      return edges_[a].source < edges_[b].source;
    });
    auto first = starts.begin();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (i > 0 && edges_[vertices[i]].source == edges_[vertices[i - 1]].source) continue;
      auto last = first;
      while (last != starts.end() && left(*last) == edges_[vertices[i]].source) ++last;
      pass(vertices[i], {first, last});
      first = last;
    }
    return std::move(found_);
  }

 private:
  const Point& left(std::size_t edge) const {
    return to_the_right_[edge] ? edges_[edge].source : edges_[edge].target;
  }
  const Point& right(std::size_t edge) const {
    return to_the_right_[edge] ? edges_[edge].target : edges_[edge].source;
  }

  /// Positive where a point is above an edge.
  int side(std::size_t edge, const Point& p, const IntervalPoint& near) const {
    const auto& [source, target] = near_[edge];
    const std::optional<int> known = orientation(source, target, near);
    const int turn = known ? *known : orientation(edges_[edge].source, edges_[edge].target, p);
    return to_the_right_[edge] ? turn : -turn;
  }
  int side_of_left(std::size_t edge, std::size_t of) const {
    return side(edge, left(of), to_the_right_[of] ? near_[of].source : near_[of].target);
  }
  int side_of_right(std::size_t edge, std::size_t of) const {
    return side(edge, right(of), to_the_right_[of] ? near_[of].target : near_[of].source);
  }

  struct Vertex {
    std::size_t edge;  ///< which starts there
  };

  /// Which of two edges, or of an edge and a vertex, is further down where the sweep is.
  struct Below {
    using is_transparent = void;
    const Sweep* sweep;

    bool operator()(std::size_t a, std::size_t b) const {
      if (a == b) return false;
      if (sweep->left(b) < sweep->left(a)) {
        const int start = sweep->side_of_left(b, a);
        return start != 0 ? start < 0 : sweep->side_of_right(b, a) < 0;
      }
      const int start = sweep->side_of_left(a, b);
      return start != 0 ? start > 0 : sweep->side_of_right(a, b) > 0;
    }
    bool operator()(std::size_t edge, Vertex v) const { return sweep->side_of(edge, v) > 0; }
    bool operator()(Vertex v, std::size_t edge) const { return sweep->side_of(edge, v) < 0; }
  };

  int side_of(std::size_t edge, Vertex v) const {
    return side(edge, edges_[v.edge].source, near_[v.edge].source);
  }

  /// The gap above `below`, if it is inside the region, ends at a vertex.
  void close(std::size_t below, std::size_t above, std::size_t vertex) {
    if (to_the_right_[below] && edges_[wall_of_[below]].source.x != edges_[vertex].source.x)
      found_.push_back({below, above, wall_of_[below], vertex});
  }

  void pass(std::size_t vertex, std::vector<std::size_t> starting) {
    // An edge in which another chain has a vertex ends there and starts again.
    const auto [first, last] = status_.equal_range(Vertex{vertex});
    const auto before = first == status_.begin() ? status_.end() : std::prev(first);
    for (auto lower = before == status_.end() ? first : before; lower != last; ++lower)
      if (const auto upper = std::next(lower); upper != status_.end())
        close(*lower, *upper, vertex);
    for (auto e = first; e != last; ++e)
      if (right(*e) != edges_[vertex].source) starting.push_back(*e);
    status_.erase(first, last);
    if (before != status_.end()) wall_of_[*before] = vertex;
    for (const std::size_t e : starting) {
      status_.insert(last, e);
      wall_of_[e] = vertex;
    }
  }

  const std::vector<Segment>& edges_;
  std::vector<IntervalSegment> near_;
  std::vector<bool> to_the_right_;  ///< of each edge; then the interior is above it
  std::set<std::size_t, Below> status_;
  std::vector<std::size_t> wall_of_;  ///< where the gap above an edge began
  std::vector<Trapezoid> found_;
};

}  // namespace

std::vector<Trapezoid> trapezoids(const std::vector<Segment>& edges) {
  return Sweep(edges).sweep();
}

}  // namespace oplus
