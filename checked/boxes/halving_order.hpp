// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "checked/boxes/box.hpp"

namespace oplus {

/// How many of a list are in its first half: a power of two, so that lists are halved as trees are that
/// are built by taking neighbours together in pairs, again and again. Requires: size >= 2.
constexpr std::uint32_t first_half(std::uint32_t size) { return std::bit_ceil(size) / 2; }

/// The numbers of the boxes, in an order in which the middles of each half of the list, each half of that, and
/// so on, are on one side of a line: halved where the middles are further apart, so that long boxes are
/// divided by their short sides. O(n log n).
std::vector<std::uint32_t> halving_order(std::span<const Box> boxes);

}  // namespace oplus
