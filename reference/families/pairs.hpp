// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/families/family.hpp"

namespace oplus {

/// The `make` of each family; what it makes and what n is stands in the table in family.cpp.
template <Region (*polygon)(Random&, std::size_t)>
Summands two(Random& random, std::size_t n) {
  return {polygon(random, n), polygon(random, n)};
}
Summands grid_pair(Random& random, std::size_t n);
Summands comb_pair(Random& random, std::size_t n);
Summands fork_pair(Random& random, std::size_t n);
Summands tight_pair(Random& random, std::size_t n);
Summands diamond_and_u_pair(Random& random, std::size_t n);
Summands holes_pair(Random& random, std::size_t n);
Summands components_pair(Random& random, std::size_t n);
Summands islands_pair(Random& random, std::size_t n);
Summands coast_pair(Random& random, std::size_t n);
Summands maze_pair(Random& random, std::size_t n);
Summands spiral_pair(Random& random, std::size_t n);
Summands thin_pair(Random& random, std::size_t n);
Summands outlier_pair(Random& random, std::size_t n);
Summands scales_pair(Random& random, std::size_t n);
Summands fractions_pair(Random& random, std::size_t n);
Summands dots_pair(Random& random, std::size_t n);
Summands sieve_pair(Random& random, std::size_t n);
Summands pockets_pair(Random& random, std::size_t n);
Summands touching_pair(Random& random, std::size_t n);

}  // namespace oplus
