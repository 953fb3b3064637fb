// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "properties/compare/conformance/answer.hpp"

namespace oplus {

/// What is wrong with an answer.
struct Failure {
  std::string kind;  ///< what tells it apart from others, with the site where there is one
  std::string what;  ///< a line on this very answer; calls the right sum "the first"
  std::optional<Point> witness;              ///< a point at which the two sums differ
  std::optional<Rational> squared_distance;  ///< of the boundaries, where it is "rounded"
};

/// Returns what is wrong with an answer, or none where it is the right sum. Of several things the
/// first of these is the kind:
///  1. "crashed: SITE", "hung", "out of memory", "unreadable: SITE", "not taken";
///  2. "not simple": a chain of fewer than three vertices or without area, edges that cross or overlap,
///     a hole in no outer chain;
///  3. "orientation": an outer chain clockwise or a hole counterclockwise;
///  4. "component lost", "component invented": one whose interior meets none of the other sum's;
///     "components joined": one meets several of the right sum's; "component split": the reverse;
///  5. the same four for holes;
///  6. "rounded": the boundaries' Hausdorff distance is at most a millionth of the right sum's extent,
///     or at most a step of the grid that the answer's coordinates are on, and vertices of the right
///     sum that are on that grid have not moved;
///  7. "area smaller", "area larger", "other shape of equal area";
///  8. "dangling edge lost", "dangling edge invented", "isolated vertex lost", "isolated vertex
///     invented";
///  9. "not canonical": the same points, written otherwise.
std::optional<Failure> failure(const MinkowskiSum& right, const Answer& answer);

/// Point 1 alone: needs no right sum. Requires: the answer has no sum.
Failure failure_without_sum(const Answer& answer);

/// Points 2 and 3: what is wrong with the answer whatever the right sum is.
std::optional<Failure> malformed(const MinkowskiSum& sum);

}  // namespace oplus
