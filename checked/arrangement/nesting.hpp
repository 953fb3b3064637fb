// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "checked/arrangement/orientable_loops.hpp"

namespace oplus {

/// What became of a loop.
enum class LoopVerdict {
  boundary,     ///< of the sum
  not_nested,   ///< an external loop directly in an external one, or a hole directly in a hole
  not_boundary  ///< a hole test found the sum on its right, too
};

/// The nesting filter (thesis, Section 3.1.2) and the boundary filter (Section 3.1.3), from the
/// outside in: directly inside an external loop of the boundary only hole loops are asked for,
/// directly inside a hole loop only external ones, and one hole test a loop decides. The loops inside
/// one that falls are judged as its siblings.
/// Requires: loops = orientable_loops(arrangement).
std::vector<LoopVerdict> judge(
    const ConvolutionArrangement& arrangement, const std::vector<OrientableLoop>& loops,
    const std::function<bool(ConvolutionArrangement::Halfedge)>& is_hole_right_of);

}  // namespace oplus
