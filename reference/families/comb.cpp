// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

Region comb_polygon(Random& random, std::size_t teeth) {
  Chain zigzag{{0, uniform(random, 1, 2)}};
  Rational x = 0;
  for (std::size_t i = 0; i < teeth; ++i) {
    x += uniform(random, 1, 3);
    zigzag.push_back({x, uniform(random, 4, 9)});
    x += uniform(random, 1, 3);
    zigzag.push_back({x, uniform(random, 1, 2)});
  }
  Chain chain{{0, 0}, {x, 0}};
  chain.insert(chain.end(), zigzag.rbegin(), zigzag.rend());
  return polygon(std::move(chain));
}

Summands comb_pair(Random& random, std::size_t n) {
  Region p = comb_polygon(random, n);
  const std::size_t points = 3 + uniform_index(random, 6);
  const int side = uniform(random, 2, 6);
  return {std::move(p), convex_grid_polygon(random, points, side)};
}

}  // namespace oplus
