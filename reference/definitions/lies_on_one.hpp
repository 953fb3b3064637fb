// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Whether p lies on one of the closed segments.
inline bool lies_on_one(const Point& p, const std::vector<Segment>& segments) {
  return std::any_of(segments.begin(), segments.end(),
                     [&](const Segment& s) { return lies_on(p, s); });
}

}  // namespace oplus
