// SPDX-License-Identifier: MIT
#include "reference/pictures/panel_frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace oplus::picture {

std::optional<BoundingBox> bounding_box(const Panel& panel) {
  std::optional<BoundingBox> box;
  const auto extend = [&](const Point& p) {
    if (!box) box = {p, p};
    if (p.x < box->low.x) box->low.x = p.x;
    if (p.y < box->low.y) box->low.y = p.y;
    if (p.x > box->high.x) box->high.x = p.x;
    if (p.y > box->high.y) box->high.y = p.y;
  };
  for (const Layer& layer : panel.layers) {
    for (const Segment& e : edges(layer.region)) extend(e.source);
    for (const Segment& s : layer.segments) {
      extend(s.source);
      extend(s.target);
    }
    for (const Point& p : layer.points) extend(p);
  }
  return box;
}

Rational extent(const Panel& panel) {
  const BoundingBox box = bounding_box(panel).value_or(BoundingBox{});
  return std::max(Rational(box.high.x - box.low.x), Rational(box.high.y - box.low.y));
}

Frame::Frame(const Panel& panel, Scale scale, double left, double top)
    : box_(bounding_box(panel).value_or(BoundingBox{})),
      scale_(std::move(scale)),
      left_(left),
      top_(top),
      width_(scale_(box_.high.x - box_.low.x)),
      height_(scale_(box_.high.y - box_.low.y)) {}

Pixel Frame::operator()(const Point& p) const {
  return {left_ + scale_(p.x - box_.low.x), top_ + scale_(box_.high.y - p.y)};
}

bool Frame::has_near(const Point& p, double margin) const {
  const Pixel at = (*this)(p);
  return at.x >= left_ - margin && at.x <= left_ + width_ + margin && at.y >= top_ - margin &&
         at.y <= top_ + height_ + margin;
}

double Frame::radius(const Rational& squared) const {
  return scale_.pixels * std::sqrt(Rational(squared / (scale_.length * scale_.length)).get_d());
}

}  // namespace oplus::picture
