// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "checked/pieces/convex_pieces.hpp"
#include "checked/pieces/shifted_doubles.hpp"

namespace oplus::certificates {

/// The pieces of a summand, or of what is compared with others. To check whether a point is in a sum of two pieces
/// takes as long as the product of their sizes, which are at most 8.
pieces::ConvexPieces pieces_of_summand(const Region& region);

/// The common denominator of the coordinates, with which boxes are exact; where that is long, a power of two with
/// which they are as exact as doubles.
mpz_class unit(const std::vector<const Region*>& regions, const pieces::ShiftedDoubles& doubles);

}  // namespace oplus::certificates
