// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/convolution.hpp"

namespace oplus {

/// A reflex vertex of a summand, at which the segments of 𝒞 may be replaced.
struct ReflexVertex {
  Summand of;
  VertexIndex vertex;
};

/// The reflex vertices of P, then those of Q.
std::vector<ReflexVertex> reflex_vertices(const Region& p, const Region& q);

/// 𝒞 with the segments of that vertex, S_c, replaced by its flip set: the other segments of 𝒮 with
/// that vertex, S_nc, each reversed (thesis, Section 4.2.3). Of every edge and reflex vertex exactly
/// one of the two sums is there, ties and equal directions included, since S_nc is what 𝒞 leaves
/// out. `origin` names the edge and the vertex as in 𝒮; the segment is directed as its edge in S_c
/// and against it in the flip set, so `segment` tells which it is.
std::vector<ConvolutionSegment> replaced_at(const ReflexVertex& vertex, const Region& p,
                                            const Region& q);

/// 𝒞′: replaced at all reflex vertices of P and of Q. So a segment is reversed iff its vertex is
/// reflex; the others are the reduced convolution.
std::vector<ConvolutionSegment> original_convolution(const Region& p, const Region& q);

}  // namespace oplus
