// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/directions_around.hpp"

namespace oplus {

DirectionsAround::DirectionsAround(std::size_t lines) {
  const auto count = static_cast<long>(lines);
  directions_.push_back({1, 0});
  for (long i = 1; i < count; ++i) directions_.push_back({count - 2 * i, i});
  for (std::size_t i = 0; i < lines; ++i) directions_.push_back(-directions_[i]);
}

}  // namespace oplus
