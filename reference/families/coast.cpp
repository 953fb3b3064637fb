// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <list>
#include <queue>
#include <utility>
#include <vector>

#include "reference/families/integer_segments.hpp"
#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

/// Machine integers; products stay below 2^43.
struct Place {
  std::int64_t x;
  std::int64_t y;
};

constexpr std::int64_t side = std::int64_t{1} << 20;

std::int64_t squared_length(const Place& a, const Place& b) {
  return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

bool inside_square(const Place& a) { return a.x >= 0 && a.x <= side && a.y >= 0 && a.y <= side; }

using Vertices = std::list<Place>;

/// The edges of a boundary in equal cells, by their first vertices.
class EdgeGrid {
 public:
  using Vertex = Vertices::const_iterator;

  explicit EdgeGrid(std::size_t count)
      : count_(static_cast<std::int64_t>(count)), cells_(count * count) {}

  std::size_t size() const { return cells_.size(); }

  void add(Vertex from, const Place& to) {
    each_cell({*from, to}, [&](std::vector<Vertex>& cell) { cell.push_back(from); });
  }
  void remove(Vertex from, const Place& to) {
    each_cell({*from, to}, [&](std::vector<Vertex>& cell) { std::erase(cell, from); });
  }

  /// Calls `visit` for each edge in the cells around some places, at least once, until it returns true.
  /// Returns whether it did.
  template <typename Visit>
  bool any_near(std::initializer_list<Place> places, const Visit& visit) {
    bool found = false;
    each_cell(places, [&](const std::vector<Vertex>& cell) {
      found = found || std::any_of(cell.begin(), cell.end(), visit);
    });
    return found;
  }

 private:
  template <typename Visit>
  void each_cell(std::initializer_list<Place> places, const Visit& visit) {
    const auto [left, right] =
        std::minmax(places, [](const Place& a, const Place& b) { return a.x < b.x; });
    const auto [low, high] =
        std::minmax(places, [](const Place& a, const Place& b) { return a.y < b.y; });
    const auto part = [&](std::int64_t c) { return std::min(c * count_ / side, count_ - 1); };
    for (std::int64_t column = part(left.x); column <= part(right.x); ++column)
      for (std::int64_t row = part(low.y); row <= part(high.y); ++row)
        visit(cells_[static_cast<std::size_t>(column * count_ + row)]);
  }

  std::int64_t count_;  ///< of columns, and of rows
  std::vector<std::vector<Vertex>> cells_;
};

class Coast {
 public:
  Coast() : vertices_{{side / 4, side / 4}, {3 * side / 4, side / 4}, {side / 2, 3 * side / 4}} {
    for (auto v = vertices_.begin(); v != vertices_.end(); ++v) push(v);
    renew_grid();
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
      grid_.remove(a, *after(a));
      const Vertex added = vertices_.insert(std::next(a), m);
      grid_.add(a, m);
      grid_.add(added, *after(added));
      push(a, added);
      if (vertices_.size() > 4 * grid_.size()) renew_grid();
      return;
    }
  }

  Chain chain() const {
    Chain chain;
    for (const Place& v : vertices_)
      chain.push_back({static_cast<long>(v.x), static_cast<long>(v.y)});
    return chain;
  }

 private:
  using Vertex = Vertices::iterator;

  struct Edge {
    std::int64_t squared_length;
    std::size_t age;  ///< so that equally long ones are told apart
    Vertex from;

    bool operator<(const Edge& other) const {
      if (squared_length != other.squared_length) return squared_length < other.squared_length;
      return age > other.age;
    }
  };

  template <typename Iterator>
  Iterator after(Iterator v) {
    ++v;
    return v == vertices_.end() ? vertices_.begin() : v;
  }

  void renew_grid() {
    grid_ =
        EdgeGrid(2 * static_cast<std::size_t>(std::sqrt(static_cast<double>(vertices_.size()))));
    for (auto v = vertices_.begin(); v != vertices_.end(); ++v) grid_.add(v, *after(v));
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
    return !grid_.any_near({*a, m, *b}, [&](Vertices::const_iterator c) {
      const Vertices::const_iterator d = after(c);
      if (c == a) return false;
      return (d == a ? runs_into(*c, *a, m) : segments_meet(*a, m, *c, *d)) ||
             (c == b ? runs_into(*d, *b, m) : segments_meet(m, *b, *c, *d));
    });
  }

  Vertices vertices_;
  EdgeGrid grid_{1};
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

Summands coast_pair(Random& random, std::size_t n) {
  const Region coast = coast_polygon(random, n);
  return {mapped(coast, [](const Point& p) { return 32 * p; }),
          star_polygon(random, std::min<std::size_t>(n, 20))};
}

}  // namespace oplus
