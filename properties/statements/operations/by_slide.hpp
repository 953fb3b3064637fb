// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/operations/sum_of.hpp"
#include "checked/slide/slide.hpp"

namespace oplus {

/// The sums that statements on operations are tested with; `diff --operation` tries all engines.
inline const SumOf by_slide = [](const Region& p, const Region& q, Boundary boundary) {
  return slide_sum(p, q, boundary).sum;
};

}  // namespace oplus
