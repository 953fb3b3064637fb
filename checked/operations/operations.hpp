// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "checked/operations/sum_of.hpp"

namespace oplus {

// What is made of Minkowski sums (docs/operations.md). Regions are valid and may be unbounded. Each function
// takes how to compute the sum of two bounded regions, and the result is a set in canonical form.

/// The open set of all x where Q + x overlaps P, the no-fit polygon: the open sum of P and -Q. Its boundary,
/// dangling edges and isolated vertices are where the two only touch.
PlanarSet no_fit(const Region& p, const Region& q, const SumOf& sum);

/// The closed set of all x where Q + x is inside P, the inner-fit polygon: the complement of the open sum of
/// P's complement and -Q. Where Q fits exactly, it has edges and points of their own.
PlanarSet inner_fit(const Region& p, const Region& q, const SumOf& sum);

/// The erosion of P by Q: inner_fit without edges and points.
PlanarSet eroded(const Region& p, const Region& q, const SumOf& sum);

/// The union of all Q + x inside P, also of those that fit exactly.
PlanarSet opened(const Region& p, const Region& q, const SumOf& sum);

/// The erosion by Q of the closed sum of P and Q.
PlanarSet closed(const Region& p, const Region& q, const SumOf& sum);

/// An operation on two sets. The programs, batch, Python and the comparison look it up here.
struct Operation {
  std::string name;
  std::string what;   ///< a line of help, after "Compute" or "Returns"
  Boundary boundary;  ///< whether the result is a closed set or an open one
  PlanarSet (*compute)(const Region& p, const Region& q, const SumOf& sum);
  /// The same of closed sets in canonical form (set_sum.hpp): P may have edges and points of its own where
  /// takes_any_p, Q always. The definitions stay the same, but that sum and nfp are sums of sets.
  PlanarSet (*compute_of_sets)(const PlanarSet& p, const PlanarSet& q, const SumOf& sum);
  bool takes_any_p;
  bool takes_spacing;  ///< whether it means something to grow Q first: results are places of Q
};

/// Those that have a command each: nfp, ifp, erode, open, close.
const std::vector<Operation>& operations();

/// "sum" and these.
std::vector<std::string> operation_names();

/// One of these; the sum is that of closed or of open regions. Throws std::invalid_argument for another name.
const Operation& operation_called(const std::string& name, Boundary of_sum = Boundary::closed);

}  // namespace oplus
