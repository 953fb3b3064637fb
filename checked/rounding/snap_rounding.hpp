// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "checked/boxes/box_tree.hpp"
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
  HotPixels(std::vector<Point> points, const Rational& step);

  /// Those of the hot pixels, each once, sorted.
  const std::vector<Point>& centres() const { return centres_; }

  /// The numbers of the centres whose pixels a segment, or a point, passes, in the order of its direction. O(log n) for each
  /// by experience.
  std::vector<std::uint32_t> numbers_passed(const Point& source, const Point& target) const;

  /// The centres themselves.
  std::vector<Point> passed(const Segment& s) const;

 private:
  using Tree = BoxTree<4>;

  Rational half_;
  Interval half_in_doubles_;
  std::vector<Point> centres_;
  std::vector<std::uint32_t> order_;  ///< of the centres, in the tree
  Tree tree_;
};

}  // namespace oplus
