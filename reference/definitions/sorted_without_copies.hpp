// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace oplus {

/// The values of a set, in their order.
template <typename Value>
std::vector<Value> sorted_without_copies(std::vector<Value> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace oplus
