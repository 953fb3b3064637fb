// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "reference/families/family.hpp"

namespace oplus {

/// How many kinds of pairs fitting_pair() makes.
inline constexpr std::size_t fitting_kinds = 5;

/// A pair for operations, and how it was made.
struct FittingPair {
  std::string how;
  Summands pair;
};

/// Makes of a pair one of which Q often fits in P, exactly too: where the open sum of a pair has dangling edges
/// and isolated vertices, -Q has exact placements in what P leaves free. Kinds:
///  0. P and Q, the larger one first;
///  1. what P leaves of the smallest box around it, and -Q; where P is that box, kind 2;
///  2. the complement of P, which is unbounded, and -Q;
///  3. the union of the copies of Q at three vertices of P, which may overlap, and Q; or at all points of the
///     edges between them;
///  4. -Q and the complement of what P leaves of its box, or of P where that is nothing; or the complement of
///     -Q instead of -Q, so that placements are those of kind 1, reflected.
/// `second` chooses the second where there are two. P is unbounded in kind 2, Q in 4, both in the second of
/// these. Requires: both summands are valid and bounded, and not empty.
FittingPair fitting_pair(const Summands& summands, std::size_t kind, bool second = false);

}  // namespace oplus
