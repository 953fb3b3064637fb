// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "checked/slide/float_box_tree.hpp"

namespace oplus::slide {

/// A segment from a to b, which are off by at most the error of a.
class SweptBox {
 public:
  SweptBox(const ApproximatePoint& a, const ApproximatePoint& b)
      : dx_(static_cast<float>(b.x - a.x)),
        dy_(static_cast<float>(b.y - a.y)),
        twice_x_(static_cast<float>(2 * a.x)),
        twice_y_(static_cast<float>(2 * a.y)),
        high_(box_of(static_cast<float>(std::max(a.x, b.x) + a.error),
                     static_cast<float>(std::max(a.y, b.y) + a.error),
                     static_cast<float>(a.error - std::min(a.x, b.x)),
                     static_cast<float>(a.error - std::min(a.y, b.y)))) {
    // Where a box meets that of the segment, floats are off by less than 2^-19 of the box's size and
    // of the segment's coordinates, and by what its ends are off.
    const float largest =
        std::max({std::abs(high_[0]), std::abs(high_[1]), std::abs(high_[2]), std::abs(high_[3])});
    const float error = 4 * static_cast<float>(a.error);
    most_dx_ = std::abs(dx_) * (1 + 0x1p-18F) + error;
    most_dy_ = std::abs(dy_) * (1 + 0x1p-18F) + error;
    around_ = (0x1p-19F * largest + 2 * error) * (most_dx_ + most_dy_) + 0x1p-100F;
  }

  /// Leaves out boxes that the segment, shifted to the right by an infinitesimal, only touches. Requires:
  /// the corners of boxes are integers; the line is that of `segment`, in integers. If the ends are
  /// integers too, boxes beyond an end are left out that begin there.
  void leave_out_touching(const NearSegment& segment, bool has_integer_ends) {
    constexpr float part = 0.25F;
    const auto moved = [](double right) { return right > 0 ? part : -part; };
    const float x = segment.dx == 0 ? moved(segment.dy) : 0,
                y = segment.dy == 0 ? moved(-segment.dx) : 0;
    const float less_x = has_integer_ends && segment.dx != 0 ? part : 0;
    const float less_y = has_integer_ends && segment.dy != 0 ? part : 0;
    high_ += box_of(x - less_x, y - less_y, -x - less_x, -y - less_y);
  }

  /// Whether the box, and the segment's line and the box, may have a point in common.
  bool may_meet(const FloatBox& box) const {
    if (!contains(box, high_)) return false;
    const float low_x = box[0], low_y = box[1], high_x = -box[2], high_y = -box[3];
    const float x = low_x + high_x - twice_x_, y = low_y + high_y - twice_y_;
    return std::abs(dx_ * y - dy_ * x) <=
           most_dx_ * (high_y - low_y) + most_dy_ * (high_x - low_x) + around_;
  }

 private:
  float dx_, dy_;
  float twice_x_, twice_y_;
  FloatBox high_;
  float around_;
  float most_dx_, most_dy_;  ///< more than their sizes
};

}  // namespace oplus::slide
