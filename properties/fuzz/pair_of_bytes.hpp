// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reference/families/family.hpp"

namespace oplus {

/// Returns the pair that any bytes stand for, valid (validity.hpp), neither summand empty; nullopt where a
/// summand that is spelled out is not valid, or both have too many edges. A byte each, 0 beyond the last one:
///  1. the bits of the largest coordinate, around the limits of slide's stages of numbers, 29 and 124 bits,
///     or the coordinates as they are; and whether all is sheared, after which nothing is parallel to an axis;
///  2. of P, then of Q: a denominator; an offset; by how little, differently, some places are moved, after
///     which parallel edges are only nearly parallel: 0 to 8 units, none if the region would not stay valid;
///  3. what P is: a summand of a pair of a family, with its size and two bytes of random bits; or spelled
///     out: chains, each their number of vertices, plus 128 for a hole of the last component, and 8-bit
///     coordinates;
///  4. what Q is: the other one of P's pair, P, -P, or as P.
/// The same bytes give the same pair, on every compiler.
std::optional<Summands> pair_of_bytes(std::string_view bytes);

/// The inverse: nullopt where a summand is empty, has other coordinates than integers of 8 bits with sign, or
/// a chain of more than 127 vertices. Requires: both are valid.
std::optional<std::string> bytes_of_pair(const Summands& summands);

}  // namespace oplus
