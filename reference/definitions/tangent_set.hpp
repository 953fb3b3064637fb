// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/direction.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// The edges that enter and leave a vertex of a chain.
struct Corner {
  Vector in;
  Vector out;
};

/// Returns the edges at vertex i of a chain.
inline Corner corner_at(const Chain& chain, std::size_t i) {
  return {chain[i] - chain[previous(i, chain.size())], chain[next(i, chain.size())] - chain[i]};
}

/// Whether the interior angle is greater than π. A vertex inside a straight line is not reflex.
bool is_reflex(const Corner& corner);

/// Whether d, a direction of one summand, is in the tangent set of a vertex of the other (thesis,
/// Definition 2.1.13, ties as in Definition 2.2.7). The tangent set of a vertex inside a straight
/// line is empty; that of a reflex vertex covers more than π.
bool in_tangent_set(const Direction& d, const Corner& corner);

}  // namespace oplus
