// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// The smallest rectangle around points whose sides are parallel to the axes.
struct ExactBox {
  Point low;
  Point high;

  explicit ExactBox(const Point& p) : low(p), high(p) {}

  void add(const Point& p) {
    if (p.x < low.x) low.x = p.x;
    if (p.y < low.y) low.y = p.y;
    if (p.x > high.x) high.x = p.x;
    if (p.y > high.y) high.y = p.y;
  }

  ExactBox enlarged(const Rational& margin) const {
    ExactBox box = *this;
    box.low = low - Vector{margin, margin};
    box.high = high + Vector{margin, margin};
    return box;
  }

  /// From the lower left one counterclockwise.
  Chain corners() const { return {low, {high.x, low.y}, high, {low.x, high.y}}; }
};

/// Requires: there is an edge.
inline ExactBox box_around(const std::vector<Segment>& edges) {
  ExactBox box(edges.at(0).source);
  for (const Segment& e : edges) {
    box.add(e.source);
    box.add(e.target);
  }
  return box;
}

}  // namespace oplus
