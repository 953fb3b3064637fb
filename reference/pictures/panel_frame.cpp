// SPDX-License-Identifier: MIT
#include "reference/pictures/panel_frame.hpp"

#include <cmath>

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

Frame::Frame(const Panel& panel, double left, double top)
    : box_(bounding_box(panel).value_or(BoundingBox{})),
      longest_side_(panel.longest_side),
      left_(left),
      top_(top) {
  const Rational w = box_.high.x - box_.low.x;
  const Rational h = box_.high.y - box_.low.y;
  extent_ = w > h ? w : h;
  if (extent_ == 0) extent_ = 1;
  width_ = pixels(w);
  height_ = pixels(h);
}

Pixel Frame::operator()(const Point& p) const {
  return {left_ + pixels(p.x - box_.low.x), top_ + pixels(box_.high.y - p.y)};
}

double Frame::radius(const Rational& squared) const {
  return longest_side_ * std::sqrt(Rational(squared / (extent_ * extent_)).get_d());
}

double Frame::pixels(const Rational& length) const {
  return longest_side_ * Rational(length / extent_).get_d();
}

}  // namespace oplus::picture
