// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "checked/repair/mend.hpp"
#include "reference/io/unchecked_input.hpp"

namespace oplus {

/// A valid region, and what was done to make it one, in the order of the input.
struct RepairedRegion {
  Region region;
  std::vector<Mend> mends;
};

/// Makes a valid region of one whose syntax is right:
///  1. open rings are closed; of equal consecutive vertices the first stays; where a chain turns back on
///     itself (a spike) the vertex is left out, repeatedly; a chain of which fewer than three vertices are
///     left is left out, and so are the holes of such an outer chain. The set that the chains enclose stays;
///  2. if then each chain is right by itself and they neither cross nor overlap, but a hole is not where it
///     belongs, chains at even depth become outer ones, and others holes of the chain around them: unless
///     that would make a hole of a component inside another one;
///  3. outer chains turn counterclockwise, holes clockwise;
///  4. if the region is still not valid, it becomes what its chains enclose by `fill`: by even_odd all of
///     them, by nonzero each outer chain counterclockwise and each hole clockwise, but those of an SVG path
///     as they run there. Without `fill`, throws InvalidInput that names the defect.
/// A region that is valid stays as it is. O(n log n) for n vertices, without `fill`.
RepairedRegion repaired(UncheckedInput input, std::optional<FillRule> fill = std::nullopt);

}  // namespace oplus
