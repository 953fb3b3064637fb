// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "properties/fuzz/fuzz_target.hpp"

namespace oplus {

/// The contract of a reader, for any text at all:
///  1. it returns a valid region, or refuses;
///  2. a refusal is one line of printable ASCII that names the file, a line and column of the text,
///     what is wrong and what was expected; so is each note, without the place;
///  3. written in any format and read again, a region is the same, and nothing needs repair;
///  4. written with few digits, it is read or refused;
///  5. what is a region is a sum: the same in canonical form.
/// Returns whether it was read. Throws FuzzFinding.
FuzzOutcome check_region_reader(std::string_view text);

/// The same for a reader of sums, 3 in the formats that can hold the sum; its region is valid, its
/// dangling edges are maximal, its isolated vertices isolated.
FuzzOutcome check_sum_reader(std::string_view text);

/// That of the readers of layouts: 1 and 2; and what is read can be checked: parts have the area that they use, and
/// where they are polygons, they have as many faults when they are read as polygons where they lie.
FuzzOutcome check_layout_reader(std::string_view text);

}  // namespace oplus
