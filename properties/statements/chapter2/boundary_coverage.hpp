// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "properties/statements/placements/open_sum.hpp"
#include "reference/definitions/convolution.hpp"

namespace oplus {

/// 𝒮 cut at its mutual intersections, and the part of it that some of its segments cover.
struct Coverage {
  std::size_t pieces = 0;              ///< of 𝒮
  std::size_t pieces_left_out = 0;     ///< not covered by a segment of the same direction
  std::size_t points_left_out = 0;     ///< ends of pieces that are on no covering segment
  std::optional<Point> bare_boundary;  ///< a point left out that is not in the open sum
};

/// Tests one point inside each piece of 𝒮 (thesis, Definition 2.2.1) and each end of a piece,
/// except the `excepted` ones. That decides for all points of 𝒮, since coverage and membership in
/// the sum are constant inside a piece, and 𝒮 contains the boundary of the sum (Theorem 2.2.6).
/// Requires: covering is a subset of vertex_edge_sum(p, q).
Coverage coverage(const Summands& summands, const std::vector<ConvolutionSegment>& covering,
                  OpenSum& open_sum, const std::set<Point>& excepted);

}  // namespace oplus
