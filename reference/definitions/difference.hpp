// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// Where a point lies with respect to a sum. A point of a dangling edge or an isolated vertex is on
/// the boundary.
Location locate(const Point& p, const PlanarSet& sum);

/// What tells two sums apart, and a point that shows it.
struct Difference {
  Point witness;
  Location in_a;
  Location in_b;
  std::string what;  ///< a line in the field's words; calls them "the first" and "the second"
};

/// Returns none iff a == b. Where the regularized sums differ, the witness is inside one and
/// outside the other. Where only dangling edges or isolated vertices differ, it is a point of one
/// that is inside or outside the other. Where the point sets are equal, so that one of the values
/// is not in canonical form, in_a == in_b. Exact: O(n log n) for n edges of both, and O(n) for each edge
/// that only one of them has, until one shows a difference; which most do.
std::optional<Difference> difference(const PlanarSet& a, const PlanarSet& b);

}  // namespace oplus
