// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/lattice_polygon.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "reference/families/integer_segments.hpp"

namespace oplus {

namespace {

using Polygon = std::vector<LatticePoint>;

/// Two edges, by the index of their first vertex, i < j, that share more than they should.
std::optional<std::pair<std::size_t, std::size_t>> find_conflict(const Polygon& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const LatticePoint& a = p[i];
      const LatticePoint& b = p[i + 1];
      const LatticePoint& c = p[j];
      const LatticePoint& d = p[next(j, n)];
      const bool conflict = j == i + 1        ? runs_into(a, b, d)
                            : next(j, n) == i ? runs_into(c, a, b)
                                              : segments_meet(a, b, c, d);
      if (conflict) return std::pair{i, j};
    }
  }
  return std::nullopt;
}

int twice_area(const Polygon& p) {
  int sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const LatticePoint& b = p[next(i, p.size())];
    sum += p[i].x * b.y - p[i].y * b.x;
  }
  return sum;
}

std::optional<Polygon> untangled(Random& random, Polygon points) {
  shuffle(random, points);
  for (std::size_t rounds = 3 * points.size(); rounds > 0; --rounds) {
    const auto conflict = find_conflict(points);
    if (!conflict) {
      if (twice_area(points) < 0) std::reverse(points.begin(), points.end());
      return points;
    }
    const auto [i, j] = *conflict;
    if (j == i + 1)
      std::swap(points[j], points[next(j, points.size())]);
    else if (next(j, points.size()) == i)
      std::swap(points[i], points[i + 1]);
    else
      std::reverse(points.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   points.begin() + static_cast<std::ptrdiff_t>(j) + 1);
  }
  return std::nullopt;
}

/// Puts a vertex inside a random edge that has room for one, if there is such an edge.
void add_collinear_vertex(Random& random, Polygon& p) {
  std::vector<std::size_t> roomy;
  const auto pieces = [&](std::size_t i) {
    const LatticePoint& b = p[next(i, p.size())];
    return std::gcd(b.x - p[i].x, b.y - p[i].y);
  };
  for (std::size_t i = 0; i < p.size(); ++i)
    if (pieces(i) > 1) roomy.push_back(i);
  if (roomy.empty()) return;
  const std::size_t i = roomy[uniform_index(random, roomy.size())];
  const int count = pieces(i);
  const int at = uniform(random, 1, count - 1);
  const LatticePoint& b = p[next(i, p.size())];
  const LatticePoint added{p[i].x + (b.x - p[i].x) / count * at,
                           p[i].y + (b.y - p[i].y) / count * at};
  p.insert(p.begin() + static_cast<std::ptrdiff_t>(i) + 1, added);
}

Chain exact(const Polygon& p) {
  Chain chain;
  chain.reserve(p.size());
  for (const LatticePoint& v : p) chain.push_back({v.x, v.y});
  return chain;
}

/// `count` of the points, at random. Requires: count <= points.size().
Polygon some_of(Random& random, Polygon points, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    std::swap(points[i], points[i + uniform_index(random, points.size() - i)]);
  points.resize(count);
  return points;
}

/// 3 to `most`, larger numbers favoured, since most degeneracies need reflex vertices; but of more
/// than 24 points no more than a third, so that polygons are found soon.
std::size_t vertex_count_up_to(Random& random, std::size_t most, std::size_t points) {
  const std::size_t bound = std::min({most, points, std::max<std::size_t>(8, points / 3)});
  const std::size_t first = uniform_index(random, bound - 2);
  const std::size_t second = uniform_index(random, bound - 2);
  return 3 + std::max(first, second);
}

}  // namespace

std::optional<Chain> polygon_through(Random& random, std::vector<LatticePoint> points) {
  const std::optional<Polygon> found = untangled(random, std::move(points));
  if (!found) return std::nullopt;
  return exact(*found);
}

Chain lattice_polygon(Random& random, int side, std::size_t most) {
  Polygon grid;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y) grid.push_back({x, y});
  const std::size_t count = vertex_count_up_to(random, most, grid.size());
  const bool collinear = count > 3 && one_in(random, 4);
  while (true) {
    std::optional<Polygon> found =
        untangled(random, some_of(random, grid, collinear ? count - 1 : count));
    if (!found) continue;
    if (collinear) add_collinear_vertex(random, *found);
    return exact(*found);
  }
}

std::optional<Chain> lattice_polygon_within(Random& random, const Chain& around, std::size_t most) {
  const Region region =
      polygon(twice_area(around) < 0 ? Chain(around.rbegin(), around.rend()) : around);
  const auto by_y = [](const Point& a, const Point& b) { return a.y < b.y; };
  const auto [left, right] = std::minmax_element(around.begin(), around.end());
  const auto [low, high] = std::minmax_element(around.begin(), around.end(), by_y);
  Polygon inside;
  for (Rational x = left->x; x <= right->x; x += 1) {
    for (Rational y = low->y; y <= high->y; y += 1) {
      if (locate({x, y}, region) == Location::outside) continue;
      inside.push_back(
          {static_cast<int>(x.get_num().get_si()), static_cast<int>(y.get_num().get_si())});
    }
  }
  // Points all over leave no room for a second one; half of the polygons are small instead.
  if (one_in(random, 2)) {
    const LatticePoint near = inside[uniform_index(random, inside.size())];
    const int distance = uniform(random, 1, 2);
    std::erase_if(inside, [&](const LatticePoint& p) {
      return std::abs(p.x - near.x) > distance || std::abs(p.y - near.y) > distance;
    });
    if (inside.size() < 3) return std::nullopt;
  }
  const std::size_t count = vertex_count_up_to(random, most, inside.size());
  return polygon_through(random, some_of(random, std::move(inside), count));
}

}  // namespace oplus
