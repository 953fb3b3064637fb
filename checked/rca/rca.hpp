// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// What a run of RCA did.
struct RcaStatistics {
  std::size_t segments = 0;  ///< of the reduced convolution
  std::size_t arrangement_vertices = 0;
  std::size_t arrangement_edges = 0;  ///< A_RC (thesis, Table 6.1)
  std::size_t arrangement_faces = 0;
  std::size_t candidate_faces = 0;  ///< left by the filter for orientable boundaries
  std::size_t hole_tests = 0;       ///< collision tests, of faces, edges and vertices
};

struct RcaResult {
  MinkowskiSum sum;
  Origins origins;  ///< empty unless asked for
  RcaStatistics statistics;
};

/// Whether the result says where each edge came from.
enum class WithOrigins { no, yes };

/// Computes P ⊕ Q by the thesis's own algorithm RCA (Sections 3.2 and 7.2): the arrangement of the
/// reduced convolution, whose edges know their segments; faces whose whole boundary is directed with
/// the face to its right are candidates for the complement (Lemma 3.1.2); a collision test each
/// decides.
/// Requires: p and q are valid (validity.hpp).
RcaResult rca(const Region& p, const Region& q, Boundary boundary,
              WithOrigins with_origins = WithOrigins::no);

}  // namespace oplus
