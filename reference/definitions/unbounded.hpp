// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/definitions/values.hpp"

namespace oplus {

/// Whether all points far enough away belong to the region: one of its components has no outer chain.
inline bool is_unbounded(const Region& region) {
  return std::any_of(region.components.begin(), region.components.end(),
                     [](const Component& component) { return component.outer.empty(); });
}

}  // namespace oplus
