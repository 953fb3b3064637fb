// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <set>
#include <utility>

#include "reference/definitions/region.hpp"
#include "reference/families/random.hpp"
#include "reference/families/rich_regions.hpp"

namespace oplus {

/// A chain on a small grid: a box, a diamond, a triangle, or any vertices; nothing is required of it.
inline Chain random_chain(Random& random, int size) {
  const auto point = [&]() -> Point {
    const int x = uniform(random, 0, size);
    const int y = uniform(random, 0, size);
    return {x, y};
  };
  const Point a = point(), b = point();
  switch (uniform(random, 0, 5)) {
    case 0:
    case 1:
      return {a, {b.x, a.y}, b, {a.x, b.y}};
    case 2: {
      const Rational r = uniform(random, 1, 3);
      return {{a.x - r, a.y}, {a.x, a.y - r}, {a.x + r, a.y}, {a.x, a.y + r}};
    }
    case 3:
    case 4:
      return {a, b, point()};
    default: {
      Chain chain{a, b, point()};
      for (int i = uniform(random, 0, 5); i > 0; --i) chain.push_back(point());
      return chain;
    }
  }
}

/// A box or diamond around the middle of the grid.
inline Chain random_ring(Random& random, int size) {
  const int low = uniform(random, 0, size / 2 - 1);
  const int high = size - low, middle = size / 2;
  if (one_in(random, 3)) return {{low, middle}, {middle, low}, {high, middle}, {middle, high}};
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}

/// Components and holes in any place, outer chains counterclockwise and holes clockwise: most are invalid,
/// in every way; of the valid ones, many have chains that touch, holes and islands. In every second case
/// the grid is mapped so that few coordinates are doubles.
inline Region random_region(Random& random) {
  const int size = uniform(random, 2, 10);
  const bool is_skewed = one_in(random, 2);
  const bool has_rings = one_in(random, 4);
  const auto chain = [&](bool counterclockwise) {
    Chain result = has_rings ? random_ring(random, size) : random_chain(random, size);
    if (is_skewed)
      for (Point& p : result) p = {p.x / 3 + p.y / 7, p.y / 5 - p.x / 11};
    if ((sgn(twice_area(result)) > 0) != counterclockwise)
      std::reverse(result.begin(), result.end());
    return result;
  };
  Region region;
  for (int c = uniform(random, 1, 3); c > 0; --c) {
    region.components.push_back({chain(true), {}});
    for (int h = uniform(random, 0, 2); h > 0; --h)
      region.components.back().holes.push_back(chain(false));
  }
  return region;
}

/// Any cells of a small grid: their chains touch in many corners, and islands are in holes of islands.
inline Region random_cells(Random& random) {
  const int size = uniform(random, 1, 9);
  std::set<std::pair<int, int>> cells;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      if (one_in(random, 2)) cells.emplace(x, y);
  return region_of_cells(cells);
}

}  // namespace oplus
