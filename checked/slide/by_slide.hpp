// SPDX-License-Identifier: MIT
#pragma once

#include "checked/slide/slide.hpp"

namespace oplus {

/// The sum alone, for what takes sums from any engine.
inline PlanarSet by_slide(const Region& p, const Region& q, Boundary boundary) {
  return slide_sum(p, q, boundary).sum;
}

}  // namespace oplus
