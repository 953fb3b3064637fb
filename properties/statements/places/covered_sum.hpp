// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/runner/each_engine.hpp"
#include "reference/definitions/convolution.hpp"

namespace oplus {

/// Whether the segments of one direction along an edge cover all of it.
bool cover(const std::vector<ConvolutionSegment>& segments, const Vector& direction,
           const Segment& edge);

/// What of a sum the segments do not cover, in words, or nothing: edges want segments of their
/// direction, dangling ones of both; isolated vertices any segment, but for the `excepted` ones,
/// sorted.
std::string bare(const MinkowskiSum& sum, const std::vector<ConvolutionSegment>& segments,
                 const std::vector<Point>& excepted);

}  // namespace oplus
