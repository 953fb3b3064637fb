// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/family.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

constexpr std::size_t large = 1'000'000;

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"grid", "simple polygons of 3 to n vertices on grids of 3x3 to 7x7 points", grid_pair, 3, 8},
      {"tight", "passages in which the other summand just fits, each leg at most n long",
       tight_pair, 1, 3},
      {"holes", "a region with holes, and one with or without; chains of 3 to n vertices",
       holes_pair, 3, 6},
      {"components", "a region of several components, and any other; chains of 3 to n vertices",
       components_pair, 3, 5},
      {"islands", "up to n islands in each other's moats, and a small convex polygon that may fit",
       islands_pair, 1, 3},
      {"convex", "two convex polygons of n vertices on circles", two<convex_polygon>, 3, 8},
      {"star", "two star-shaped polygons of n vertices", two<star_polygon>, 3, 8},
      {"simple", "two simple polygons of n vertices, from Delaunay triangulations",
       two<simple_polygon>, 3, 8},
      {"comb", "a comb of n teeth, and a small convex polygon", comb_pair, 1, 4, large},
      {"fork", "a fork with n teeth on each arm, and an L: their sum has n^2 holes", fork_pair, 1,
       3},
      {"diamond-u", "a room with a hatch, and a diamond that just fits it or nearly; n is not used",
       diamond_and_u_pair, 1, 1},
      {"coast", "a coastline of n vertices, and a much smaller star of at most 20", coast_pair, 3,
       8, large},
      {"maze", "the corridors of a maze of n rooms, 4n vertices, and a small convex polygon",
       maze_pair, 1, 3, large},
      {"spiral", "a square spiral corridor of n corners, and a small convex polygon", spiral_pair,
       1, 4, large},
      {"thin", "a long thin saw of n teeth, and a long thin bar across it", thin_pair, 1, 3, large},
      {"outlier", "a comb of n teeth, one of them 10^9 long, and a small convex polygon",
       outlier_pair, 1, 4, large},
      {"scales", "a star of n vertices, and one of at most 20 that is 10^12 times as large",
       scales_pair, 3, 6},
      {"fractions",
       "a comb of n teeth and a triangle, each coordinate with a denominator of its own",
       fractions_pair, 1, 3, large},
      {"dots", "n small convex polygons each, far apart, in random order", dots_pair, 1, 3, large},
      {"sieve", "a square with n convex holes in random order, and a small convex polygon",
       sieve_pair, 1, 3, large},
      {"pockets", "a square with n holes into which Q just fits or nearly, and Q", pockets_pair, 1,
       3, large},
      {"touching", "n squares each, in a row from corner to corner", touching_pair, 1, 3, large},
  };
  return all;
}

const Family* find_family(const std::string& name) {
  const std::vector<Family>& all = families();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Family& f) { return f.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Summands generate(const Family& family, std::size_t n, std::uint64_t seed) {
  if (n < family.smallest)
    throw std::invalid_argument("family " + family.name + ": n is " + std::to_string(n) +
                                ", must be at least " + std::to_string(family.smallest));
  Random random(seed);
  return family.make(random, n);
}

}  // namespace oplus
