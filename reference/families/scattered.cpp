// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/definitions/exact_box.hpp"
#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"

// Very many components or holes.

namespace oplus {

namespace {

/// The lower left corners of n squares of a grid, as square as it can be, in random order.
std::vector<Point> places(Random& random, std::size_t n, int pitch) {
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  std::vector<Point> result;
  result.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
    result.push_back(
        {pitch * static_cast<int>(i % columns), pitch * static_cast<int>(i / columns)});
  shuffle(random, result);
  return result;
}

Region dots(Random& random, std::size_t n) {
  Region region;
  for (const Point& at : places(random, n, 12))
    region.components.push_back(
        {translated(convex_grid_polygon(random, 5, 6).components[0].outer, at), {}});
  return region;
}

/// A square around n holes, `hole` each at one of the places.
template <typename Hole>
Region pierced_square(Random& random, std::size_t n, int pitch, const Hole& hole) {
  const int side = pitch * static_cast<int>(std::ceil(std::sqrt(static_cast<double>(n))));
  Component component{{{-1, -1}, {side, -1}, {side, side}, {-1, side}}, {}};
  for (const Point& at : places(random, n, pitch)) {
    Chain chain = translated(hole(), at);
    std::reverse(chain.begin(), chain.end());
    component.holes.push_back(std::move(chain));
  }
  return {{std::move(component)}};
}

}  // namespace

Summands dots_pair(Random& random, std::size_t n) {
  Region p = dots(random, n);
  return {std::move(p), dots(random, n)};
}

Summands sieve_pair(Random& random, std::size_t n) {
  Region p = pierced_square(random, n, 12,
                            [&] { return convex_grid_polygon(random, 6, 10).components[0].outer; });
  return {std::move(p), convex_grid_polygon(random, 4, 3)};
}

/// Holes as wide and high as Q, or larger by one in a direction or both.
Summands pockets_pair(Random& random, std::size_t n) {
  const int side = 5;
  Region q = convex_grid_polygon(random, 5, side);
  const ExactBox box = box_around(edges(q));
  Region p = pierced_square(random, n, side + 2, [&] {
    Point size = box.high - box.low;
    size.x += one_in(random, 4);
    size.y += one_in(random, 4);
    return Chain{{0, 0}, {size.x, 0}, size, {0, size.y}};
  });
  return {std::move(p), std::move(q)};
}

Summands touching_pair(Random& random, std::size_t n) {
  const auto row = [&] {
    Region region;
    int at = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const int end = at + uniform(random, 1, 2);
      region.components.push_back({{{at, at}, {end, at}, {end, end}, {at, end}}, {}});
      at = end;
    }
    return region;
  };
  Region p = row();
  return {std::move(p), row()};
}

}  // namespace oplus
