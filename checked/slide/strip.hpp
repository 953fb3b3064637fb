// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "checked/slide/float_box_tree.hpp"

namespace oplus::slide {

/// The line of a segment, as wide as the segment's doubles may be off.
inline Strip strip_along(const NearSegment& s) {
  const double place = s.dx * s.y - s.dy * s.x;
  const double error =
      0x1p-48 * (std::abs(s.dx * s.y) + std::abs(s.dy * s.x) + std::abs(s.dx * s.dy));
  return {s.dx, s.dy, place - error, place + error};
}

namespace detail {

/// Whether all between two points is beside a strip widened by `reach` on both sides and moved by
/// (x, y). The largest coordinates in what these were computed from are most_x and most_y.
inline bool is_beside(const Strip& strip, double x, double y, double reach, double most_x,
                      double most_y, const ApproximatePoint& from, const ApproximatePoint& to) {
  const auto place = [&](const ApproximatePoint& at) {
    return strip.dx * (at.y - y) - strip.dy * (at.x - x);
  };
  most_x += std::max(std::abs(from.x), std::abs(to.x));
  most_y += std::max(std::abs(from.y), std::abs(to.y));
  const double dx = std::abs(strip.dx), dy = std::abs(strip.dy);
  const double margin =
      reach + 0x1p-47 * (dx * most_y + dy * most_x) + from.error * (dx + dy) + 0x1p-400;
  const double a = place(from), b = place(to);
  return std::max(a, b) < strip.low - margin || std::min(a, b) > strip.high + margin;
}

}  // namespace detail

/// Whether no place between two is in the sum of a strip and a segment.
inline bool is_beside(const Strip& strip, const NearSegment& s, const ApproximatePoint& from,
                      const ApproximatePoint& to) {
  return detail::is_beside(
      strip, s.x + s.dx / 2, s.y + s.dy / 2, std::abs(strip.dx * s.dy - strip.dy * s.dx) / 2,
      std::abs(s.x) + std::abs(s.dx), std::abs(s.y) + std::abs(s.dy), from, to);
}

/// Whether no place between two is in the sum of a strip and a box.
inline bool is_beside(const Strip& strip, const FloatBox& box, const ApproximatePoint& from,
                      const ApproximatePoint& to) {
  const double low_x = static_cast<double>(box[0]), low_y = static_cast<double>(box[1]);
  const double high_x = -static_cast<double>(box[2]), high_y = -static_cast<double>(box[3]);
  return detail::is_beside(
      strip, (low_x + high_x) / 2, (low_y + high_y) / 2,
      (std::abs(strip.dx) * (high_y - low_y) + std::abs(strip.dy) * (high_x - low_x)) / 2,
      std::max(std::abs(low_x), std::abs(high_x)), std::max(std::abs(low_y), std::abs(high_y)),
      from, to);
}

}  // namespace oplus::slide
