// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "properties/runner/each_engine.hpp"
#include "reference/definitions/convolution.hpp"

namespace oplus {

/// Whether those of the segments that overlap an edge cover all of it.
bool cover(const std::vector<Segment>& segments, const Segment& edge);

/// Whether those of one direction do.
bool cover(const std::vector<ConvolutionSegment>& segments, const Vector& direction,
           const Segment& edge);

/// What of a sum the segments do not cover, in words; empty if they cover all: each edge by
/// segments of its direction, dangling edges by segments of both directions, isolated vertices by
/// any segment, except for the `excepted` ones.
std::string bare(const PlanarSet& sum, const std::vector<ConvolutionSegment>& segments,
                 const std::set<Point>& excepted);

/// Where isolated vertices may be on no segment of the reduced convolution (docs/findings.md, on
/// Theorem 2.3.2).
std::set<Point> sums_of_touching_points(const Summands& summands);

}  // namespace oplus
