// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace oplus::certificates {

struct Place {
  double x = 0;
  double y = 0;
};

/// The numbers of the places in an order in which each half, of that each half, and so on, lies in a box that is small:
/// halved where the box of the places is longer. The first half is the smaller one. O(n log n).
std::vector<std::uint32_t> halving_order(const std::vector<Place>& places);

}  // namespace oplus::certificates
