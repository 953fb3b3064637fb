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

/// Empty for a panel without a point.
std::optional<BoundingBox> bounding_box(const Panel& panel);

/// A length and the pixels that stand for it. Lengths are divided by it exactly, so huge and tiny coordinates
/// do not overflow.
struct Scale {
  double pixels;
  Rational length;

  double operator()(const Rational& l) const { return pixels * Rational(l / length).get_d(); }
};

/// The longer side of a panel's bounding box; 0 for a panel without a point.
Rational extent(const Panel& panel);

/// Where a panel stands on the page and how its coordinates become pixels.
class Frame {
 public:
  Frame(const Panel& panel, Scale scale, double left, double top);

  double width() const { return width_; }
  double height() const { return height_; }

  Pixel operator()(const Point& p) const;

  /// Whether a point is in the panel or at most `margin` pixels outside.
  bool has_near(const Point& p, double margin) const;

  /// The radius in pixels of a disk whose radius has this square.
  double radius(const Rational& squared) const;

 private:
  BoundingBox box_;
  Scale scale_;
  double left_;
  double top_;
  double width_;
  double height_;
};

}  // namespace oplus::picture
