// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "properties/compare/no_sum.hpp"
#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// What is wrong with a sum that was given, or that there is none.
struct Failure {
  std::string kind;       ///< what tells it apart from others, with the site where there is one
  std::string what = {};  ///< a line on this very sum; calls the right sum "the first"
  std::optional<Point> witness = {};              ///< a point at which the two sums differ
  std::optional<Rational> squared_distance = {};  ///< of the boundaries, where it is "rounded"
};

/// "crashed: SITE", "hung", "out of memory", "unreadable: SITE", "not taken".
Failure failure_without_sum(const NoSum& answer);

/// Returns what is wrong with a sum, or none where it is the right one. Of several things the first of
/// these is the kind:
///  1. "not simple": a chain of fewer than three vertices or without area, edges that cross or overlap,
///     a hole in no outer chain;
///  2. "orientation": an outer chain clockwise or a hole counterclockwise;
///  3. "component lost", "component invented": one whose interior meets none of the other sum's;
///     "components joined": one meets several of the right sum's; "component split": the reverse;
///  4. the same four for holes;
///  5. "rounded": the boundaries' Hausdorff distance is at most a millionth of the right sum's extent,
///     or at most a step of the grid that the given coordinates are on, and vertices of the right
///     sum that are on that grid have not moved;
///  6. "area smaller", "area larger", "other shape of equal area";
///  7. "dangling edge lost", "dangling edge invented", "isolated vertex lost", "isolated vertex
///     invented";
///  8. "not canonical": the same points, written otherwise.
std::optional<Failure> failure(const MinkowskiSum& right, const MinkowskiSum& given);

/// Points 1 and 2: what is wrong with a sum whatever the right one is.
std::optional<Failure> malformed(const MinkowskiSum& sum);

}  // namespace oplus
