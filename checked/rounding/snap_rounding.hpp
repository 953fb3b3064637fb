// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "checked/collision/segment_tree.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus {

/// The multiple of the step next to a number; of two that are as near, the larger one.
/// Requires: step > 0.
Rational nearest_multiple(const Rational& value, const Rational& step);

/// The same of both coordinates: the centre of the pixel that contains a point. A pixel is a square of side
/// `step`, centred on a point of the grid, with its left and lower sides and without the others, so that each point
/// of the plane is in one pixel.
Point nearest_grid_point(const Point& p, const Rational& step);

/// Whether both coordinates are multiples of the step.
bool is_on_grid(const Point& p, const Rational& step);

/// Snap rounding (Hobby 1999; Guibas and Marimont 1998): the pixels that contain a given point are hot, and a segment
/// becomes the polyline through the centres of the hot pixels that it passes, in their order.
///
/// Laws, for points that include all ends of the segments and all points in which two of them meet, if they don't
/// overlap:
///  1. each point of a segment moves by at most step / 2 in x and in y;
///  2. polylines meet in vertices of both only, or along edges of both;
///  3. no point passes through a segment.
class HotPixels {
 public:
  /// Near-linear in the points. Requires: step > 0.
  HotPixels(const std::vector<Point>& points, const Rational& step);

  /// The centres of the hot pixels that a segment, or a point, passes, in the order of its direction. O(log n) for each by
  /// experience.
  std::vector<Point> passed(const Segment& s) const;

 private:
  Rational half_;
  Rational step_;
  double half_in_doubles_;  ///< or a little more
  SegmentTree centres_;     ///< each as a segment without length
};

}  // namespace oplus
