// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

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

/// A fork with `teeth` teeth on each of its two arms, 8n + 4 vertices, and a long thin L: their sum
/// has exactly n² holes (thesis, Section 6.1.4). Requires: teeth >= 1.
Summands fork_and_l(std::size_t teeth);

/// A room with a hatch of width 1 in its roof, from (3,5) and (4,5) up to (3-eps1,6) and (4,6), and
/// a diamond of width 1 + eps2 (thesis, Section 6.4). With neither perturbation the diamond just
/// slides through: the open sum has a dangling edge between its hole and its outer chain.
/// Requires: 0 <= eps1 < 3, 0 <= eps2.
Summands diamond_and_u(const Rational& eps1, const Rational& eps2);

}  // namespace oplus
