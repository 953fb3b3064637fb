// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/fuzz/fuzz_target.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// What slide must do with a pair, closed and open:
///  1. it finds the sum that winding numbers find, origins included;
///  2. also with larger numbers than are needed, from as many pieces;
///  3. it decides pairs of edges with the numbers that the coordinates need, or that were asked for;
///  4. it finds the same with P and Q exchanged;
///  5. the sum is a valid region, whose canonical form it is.
/// Throws FuzzFinding. Requires: both are valid.
void check_slide(const Summands& summands);

}  // namespace oplus
