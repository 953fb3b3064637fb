// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "checked/arrangement/convolution_arrangement.hpp"

namespace oplus {

/// A closed sequence of halfedges, each in the direction of its segments, each ending where the next
/// starts (thesis, Definition 3.1.1).
using OrientableLoop = std::vector<ConvolutionArrangement::Halfedge>;

/// Traces orientable loops, turning clockwise most (thesis, Algorithm 1). They are edge-disjoint, do
/// not cross (Observation 3.2.5), and contain the regularized boundary (Observation 3.2.4). Edges
/// with segments in both directions are left out: they are not on it (Lemma 3.1.2). Linear in the
/// size of the arrangement, but for vertices of many edges.
std::vector<OrientableLoop> orientable_loops(const ConvolutionArrangement& arrangement);

}  // namespace oplus
