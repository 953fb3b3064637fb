// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "checked/slide/box_tree.hpp"

namespace oplus::slide {

/// A segment from a to b, and all around it that is nearer than a margin.
class SweptBox {
 public:
  SweptBox(const NearPoint& a, const NearPoint& b, double margin)
      : dx_(static_cast<float>(b.x - a.x)),
        dy_(static_cast<float>(b.y - a.y)),
        twice_x_(static_cast<float>(2 * a.x)),
        twice_y_(static_cast<float>(2 * a.y)),
        high_(box_of(static_cast<float>(std::max(a.x, b.x) + margin),
                     static_cast<float>(std::max(a.y, b.y) + margin),
                     static_cast<float>(margin - std::min(a.x, b.x)),
                     static_cast<float>(margin - std::min(a.y, b.y)))),
        around_(4 * static_cast<float>(margin) * (std::abs(dx_) + std::abs(dy_))) {}

  /// Whether the box, and the segment's line and the box, may have a point in common.
  bool may_meet(const Box& box) const {
    if (!contains(box, high_)) return false;
    const float low_x = box[0], low_y = box[1], high_x = -box[2], high_y = -box[3];
    const float x = low_x + high_x - twice_x_, y = low_y + high_y - twice_y_;
    return std::abs(dx_ * y - dy_ * x) <=
           std::abs(dx_) * (high_y - low_y) + std::abs(dy_) * (high_x - low_x) + around_;
  }

 private:
  float dx_, dy_;
  float twice_x_, twice_y_;
  Box high_;
  float around_;
};

}  // namespace oplus::slide
