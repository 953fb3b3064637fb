// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "reference/pictures/picture.hpp"
#include "reference/pictures/svg_elements.hpp"

namespace oplus::picture {

struct BoundingBox {
  Point low;
  Point high;
};

/// None for a panel without a point.
std::optional<BoundingBox> bounding_box(const Panel& panel);

/// Where a panel stands on the page and how its coordinates become pixels. The difference to the
/// corner is divided by the extent exactly, so huge and tiny coordinates do not overflow.
class Frame {
 public:
  Frame(const Panel& panel, double left, double top);

  double width() const { return width_; }
  double height() const { return height_; }

  Pixel operator()(const Point& p) const;

  /// The radius in pixels of a disk whose radius has this square.
  double radius(const Rational& squared) const;

 private:
  double pixels(const Rational& length) const;

  BoundingBox box_;
  Rational extent_;
  double longest_side_;
  double left_;
  double top_;
  double width_ = 0;
  double height_ = 0;
};

}  // namespace oplus::picture
