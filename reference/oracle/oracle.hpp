// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/verdicts_differ.hpp"

namespace oplus {

/// How many cells of the arrangement of 𝒞 the oracle decided.
struct CellCount {
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t vertices = 0;
};

/// Both sums of two regions, from one arrangement.
struct OracleSums {
  PlanarSet closed;
  PlanarSet open;
  CellCount cells;
};

/// Computes P ⊕ Q by the definitions, O(n²m²) and more: the arrangement of the convolution 𝒞; a
/// face is in the sum iff its winding number is positive (thesis, Theorem 4.2.1), iff the interiors of
/// P and -Q+x meet for a point x in it, and iff the tangent count of x is positive; the three are
/// independent. The second verdict alone decides edges and vertices, that is, dangling edges and
/// isolated vertices. Requires: p and q are valid (validity.hpp). Throws VerdictsDiffer.
OracleSums oracle_sums(const Region& p, const Region& q);

/// One of the two.
PlanarSet oracle_sum(const Region& p, const Region& q, Boundary boundary);

}  // namespace oplus
