// SPDX-License-Identifier: MIT
#pragma once

#include "checked/operations/sum_of.hpp"

namespace oplus {

/// Returns the sum of two closed sets, each a region with dangling edges and isolated vertices
/// (docs/polylines.md), in canonical form. `sum` computes that of the two regions, where neither is empty.
///
/// Boundary::closed: all p + q, a closed set. Two edges make a parallelogram, or an edge where they are
/// parallel; points move what the other set is.
///
/// Boundary::open: all x for which -Q + x meets the interior of P, or its interior meets P; an open set. In
/// other words P ⊕ int Q and int P ⊕ Q together. For two regions it is the sum of their interiors; it is
/// empty for two sets without inner points.
///
/// Requires: both are bounded and canonical. Exact. For n edges of one set and m of the other, and k pairs
/// of places and edges of their arrangement through them: O((nm + k) log nm) besides the call of `sum`.
PlanarSet set_sum(const PlanarSet& p, const PlanarSet& q, Boundary boundary, const SumOf& sum);

/// Whether a closed set has a dangling edge or an isolated vertex.
inline bool has_edge_or_point(const PlanarSet& set) {
  return !set.dangling_edges.empty() || !set.isolated_vertices.empty();
}

/// Whether a closed set is empty.
inline bool is_empty(const PlanarSet& set) {
  return !set.is_unbounded && set.outer.empty() && !has_edge_or_point(set);
}

}  // namespace oplus
