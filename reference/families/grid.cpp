// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/lattice_polygon.hpp"
#include "reference/families/pairs.hpp"

namespace oplus {

namespace {

/// A side of 3 to 7 points, and more where that many vertices need more room.
int side_for(Random& random, std::size_t n) {
  int side = uniform(random, 3, 7);
  while (n > 8 && static_cast<std::size_t>(side) * static_cast<std::size_t>(side) < 3 * n) ++side;
  return side;
}

Region grid_polygon(Random& random, std::size_t n) {
  const int side = side_for(random, n);
  return polygon(lattice_polygon(random, side, n));
}

}  // namespace

Summands grid_pair(Random& random, std::size_t n) {
  Region p = grid_polygon(random, n);
  // The polygon itself, or turned by π, gives the most coincidences: P ⊕ P and P ⊖ P.
  if (one_in(random, 16)) return {p, one_in(random, 2) ? p : reflected(p)};
  return {p, grid_polygon(random, n)};
}

}  // namespace oplus
