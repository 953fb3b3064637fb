// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <list>
#include <queue>

#include "reference/families/integer_segments.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

/// Machine integers: each new vertex is compared with all edges. Products stay below 2^43.
struct Place {
  std::int64_t x;
  std::int64_t y;
};

constexpr std::int64_t side = std::int64_t{1} << 20;

std::int64_t squared_length(const Place& a, const Place& b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

bool inside_square(const Place& a) { return a.x >= 0 && a.x <= side && a.y >= 0 && a.y <= side; }

class Coast {
 public:
  Coast() : vertices_{{side / 4, side / 4}, {3 * side / 4, side / 4}, {side / 2, 3 * side / 4}} {
    for (auto v = vertices_.begin(); v != vertices_.end(); ++v) push(v);
  }

  std::size_t size() const { return vertices_.size(); }
  bool is_stuck() const { return edges_.empty(); }

  /// Tries the longest edge. One that takes no vertex stays as it is.
  void grow(Random& random) {
    const Vertex a = edges_.top().from;
    edges_.pop();
    for (int attempt = 0; attempt < 8; ++attempt) {
      const Place m = beside_middle(random, *a, *after(a));
      if (!fits(m, a)) continue;
      push(a, vertices_.insert(std::next(a), m));
      return;
    }
  }

  Chain chain() const {
    Chain chain;
    for (const Place& v : vertices_) chain.push_back({Rational(v.x), Rational(v.y)});
    return chain;
  }

 private:
  using Vertex = std::list<Place>::iterator;

  struct Edge {
    std::int64_t squared_length;
    std::size_t age;  ///< so that equally long ones are told apart
    Vertex from;

    bool operator<(const Edge& other) const {
      if (squared_length != other.squared_length) return squared_length < other.squared_length;
      return age > other.age;
    }
  };

  Vertex after(Vertex v) {
    ++v;
    return v == vertices_.end() ? vertices_.begin() : v;
  }

  void push(Vertex from) { edges_.push({squared_length(*from, *after(from)), pushed_++, from}); }
  void push(Vertex first, Vertex second) {
    push(first);
    push(second);
  }

  /// To either side, by 6/64 to 24/64 of the edge's length.
  static Place beside_middle(Random& random, const Place& a, const Place& b) {
    const int by = uniform(random, 6, 24);
    const int to = one_in(random, 2) ? by : -by;
    return {(a.x + b.x) / 2 - (b.y - a.y) * to / 64, (a.y + b.y) / 2 + (b.x - a.x) * to / 64};
  }

  /// Whether the boundary is still simple with m between a and the vertex after it: the two new edges
  /// meet no other, but their neighbours at a and b, and those there only.
  bool fits(const Place& m, Vertex a) {
    const Vertex b = after(a);
    if (!inside_square(m) || turn(*a, *b, m) == 0) return false;
    for (Vertex c = vertices_.begin(); c != vertices_.end(); ++c) {
      const Vertex d = after(c);
      if (c == a) continue;
      if (d == a ? runs_into(*c, *a, m) : segments_meet(*a, m, *c, *d)) return false;
      if (c == b ? runs_into(*d, *b, m) : segments_meet(m, *b, *c, *d)) return false;
    }
    return true;
  }

  std::list<Place> vertices_;
  std::priority_queue<Edge> edges_;
  std::size_t pushed_ = 0;
};

}  // namespace

Region coast_polygon(Random& random, std::size_t n) {
  while (true) {
    Coast coast;
    while (coast.size() < n && !coast.is_stuck()) coast.grow(random);
    Chain chain = coast.chain();
    if (chain.size() == n && twice_area(chain) > 0) return polygon(std::move(chain));
  }
}

}  // namespace oplus
