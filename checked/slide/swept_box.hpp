// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "checked/slide/box_tree.hpp"

namespace oplus::slide {

/// A segment from a to b, and all around it that is nearer than a margin.
class SweptBox {
 public:
  SweptBox(const NearPoint& a, const NearPoint& b, double margin)
      : dx_(b.x - a.x),
        dy_(b.y - a.y),
        twice_x_(2 * a.x),
        twice_y_(2 * a.y),
        high_(box_of(static_cast<float>(std::max(a.x, b.x) + margin),
                     static_cast<float>(std::max(a.y, b.y) + margin),
                     static_cast<float>(margin - std::min(a.x, b.x)),
                     static_cast<float>(margin - std::min(a.y, b.y)))),
        around_(2 * margin * (std::abs(dx_) + std::abs(dy_))) {}

  /// Whether the box, and the segment's line and the box, may have a point in common.
  bool may_meet(const Box& box) const {
    if (!contains(box, high_)) return false;
    const auto low_x = static_cast<double>(box[0]), low_y = static_cast<double>(box[1]),
               high_x = -static_cast<double>(box[2]), high_y = -static_cast<double>(box[3]);
    const double x = low_x + high_x - twice_x_, y = low_y + high_y - twice_y_;
    return std::abs(dx_ * y - dy_ * x) <=
           std::abs(dx_) * (high_y - low_y) + std::abs(dy_) * (high_x - low_x) + around_;
  }

 private:
  double dx_, dy_;
  double twice_x_, twice_y_;
  Box high_;
  double around_;
};

}  // namespace oplus::slide
