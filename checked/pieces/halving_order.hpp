// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace oplus::pieces {

struct Place {
  double x = 0;
  double y = 0;
};

/// How many of a list are in its first half: a power of two, so that lists are halved as trees are that
/// are built by taking neighbours together in pairs, again and again. Requires: size >= 2.
constexpr std::size_t first_half(std::size_t size) { return std::bit_ceil(size) / 2; }

/// The numbers of the places, in an order in which each half of the list, each half of that, and so on, is
/// on one side of a line: halved across the longer side of the box of the places. O(n log n).
std::vector<std::uint32_t> halving_order(const std::vector<Place>& places);

}  // namespace oplus::pieces
