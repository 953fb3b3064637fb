// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// An operation by its definition: which points are in P ∘ Q.
struct DefinedOperation {
  std::string name;        ///< as in properties/compare/operation.hpp
  std::string definition;  ///< a line: "all x for which ..."

  /// Requires: p and q are valid; both may be unbounded. Throws VerdictsDiffer where the points make no
  /// closed, or no open, set, which the definition says they do.
  PlanarSet (*compute)(const Region& p, const Region& q);
};

/// All of them, each decided at one point of each cell of the arrangement of all vertex-edge sums:
/// O(n²m²) cells and more for n and m edges, each of which costs O((n + m)²) and more.
const std::vector<DefinedOperation>& defined_operations();

/// nullptr where there is none of that name.
const DefinedOperation* find_defined_operation(const std::string& name);

}  // namespace oplus
