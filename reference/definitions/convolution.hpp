// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/direction.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// A segment of the vertex-edge sum, directed as its edge. The sum's interior is to its left
/// (thesis, Observation 2.2.4).
struct ConvolutionSegment {
  Segment segment;
  Origin origin;
  bool vertex_is_reflex;  ///< then the segment is not in the reduced convolution
};

/// 𝒮 = all (edge, vertex) pairs, 2nm for n and m vertices (thesis, Definition 2.2.1).
std::vector<ConvolutionSegment> vertex_edge_sum(const Region& p, const Region& q);

/// 𝒞 = P ⊗ Q, the segments of 𝒮 whose direction is in the tangent set of their vertex (thesis,
/// Definition 2.2.7).
std::vector<ConvolutionSegment> convolution(const Region& p, const Region& q);

/// The segments of 𝒞 whose vertex is not reflex (thesis, Definition 2.3.1).
std::vector<ConvolutionSegment> reduced_convolution(const Region& p, const Region& q);

/// The geometry alone.
std::vector<Segment> segments(const std::vector<ConvolutionSegment>& convolution);

}  // namespace oplus
