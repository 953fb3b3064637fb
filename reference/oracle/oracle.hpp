// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// The two verdicts of the oracle differ on a cell: Theorem 4.2.1 is false, or one of the
/// definitions is wrong. Never seen on a valid region.
class VerdictsDiffer : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// How many cells of the arrangement of 𝒞 the oracle decided.
struct CellCount {
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t vertices = 0;
};

/// Both sums of two regions, from one arrangement.
struct OracleSums {
  MinkowskiSum closed;
  MinkowskiSum open;
  CellCount cells;
};

/// Computes P ⊕ Q by the definitions, O(n²m²) and more: the arrangement of the convolution 𝒞; a
/// face is in the sum iff its winding number is positive (thesis, Theorem 4.2.1) and,
/// independently, iff the interiors of P and -Q+x meet for a point x in it. The second verdict
/// alone decides edges and vertices, that is, dangling edges and isolated vertices. Requires: p and
/// q are valid (validity.hpp). Throws VerdictsDiffer.
OracleSums oracle_sums(const Region& p, const Region& q);

/// One of the two.
MinkowskiSum oracle_sum(const Region& p, const Region& q, Boundary boundary);

}  // namespace oplus
