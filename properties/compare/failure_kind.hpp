// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "properties/compare/engine_failure.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// What is wrong with a sum that was given, or why there is no sum.
struct Failure {
  std::string kind;       ///< what tells it apart from others, with the site where there is one
  std::string what = {};  ///< a line on this very sum; calls the right sum "the first"
  std::optional<Point> witness = {};              ///< a point at which the two sums differ
  std::optional<Rational> squared_distance = {};  ///< of the boundaries, where it is "rounded"
};

/// "crashed: SITE", "hung", "out of memory", "unreadable: SITE". Requires: is_fault(answer.kind()).
Failure failure_without_sum(const EngineFailure& answer);

/// Returns what is wrong with a sum, or nullopt if it is the right one. The kind is the first of these that
/// applies:
///  1. "not simple": a chain of fewer than three vertices or without area, edges that cross or overlap,
///     a hole in no outer chain;
///  2. "orientation": an outer chain clockwise or a hole counterclockwise;
///  3. "component lost", "component invented": one whose interior meets none of the other sum's;
///     "components joined": one meets several of the right sum's; "component split": the reverse;
///  4. the same four for holes;
///  5. "rounded": the topology is unchanged and all vertices are close. Let m be a millionth of the largest
///     absolute value of a coordinate of the right sum, and d the least common denominator of all given
///     coordinates. No kind of 3 and 4 applies, and each component of the right sum has a given one with
///     as many holes such that their outer chains, and each hole of the first and some hole of the other,
///     are equal but for rounding. Two chains are that if their corners are equally many and can be
///     paired in cyclic order such that in each pair each coordinate differs by at most m or by less
///     than 1/d. (So a multiple of 1/d has not moved by more than m.) All vertices are corners but those
///     that, from the second on, are at most m away from the segment that joins the last corner before
///     with the vertex behind: rounding makes such vertices and loses them. And no point of one sum's
///     boundary is farther than √2 max(m, 1/d) from the other's;
///  6. "area smaller", "area larger", "other shape of equal area";
///  7. "dangling edge lost", "dangling edge invented", "isolated vertex lost", "isolated vertex
///     invented";
///  8. "not canonical": the same set of points in another form.
std::optional<Failure> failure(const PlanarSet& right, const PlanarSet& given);

/// Kinds 1 and 2, for which the right sum is not needed.
std::optional<Failure> malformed(const PlanarSet& sum);

}  // namespace oplus
