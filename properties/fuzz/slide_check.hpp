// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "properties/fuzz/fuzz_target.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// Which laws of check_slide: 1, 3 and 5 always; with `all`, 2 in all numbers, and 4. These take most of
/// the time.
enum class SlideLaws { as_needed, at_least_128_bits, gmp, rationals, exchanged, all };

/// What slide must do with a pair, closed and open:
///  1. it finds the sum of convex parts (sum_by_convex_parts.hpp), with the origins by their definition;
///  2. also with larger numbers than are needed, from as many pieces;
///  3. it decides pairs of edges with the numbers that the coordinates need, or that were asked for;
///  4. it finds the same with P and Q exchanged;
///  5. the sum is a valid region, whose canonical form it is.
/// Throws FuzzFinding. Requires: both are valid.
void check_slide(const Summands& summands, SlideLaws laws = SlideLaws::all);

/// What slide is to find.
struct ExpectedSums {
  PlanarSet closed;
  PlanarSet open;
  Origins origins_of_closed;
  Origins origins_of_open;
};
ExpectedSums expected_sums(const Summands& summands);

/// The same where the sums are already known.
void check_slide(const Summands& summands, const ExpectedSums& expected, SlideLaws laws);

/// One input of slide in eight is checked for law 2 in some numbers, or for law 4: which, depends on its
/// bytes only.
SlideLaws laws_for(std::string_view bytes);

}  // namespace oplus
