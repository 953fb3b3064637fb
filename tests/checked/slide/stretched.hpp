// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

inline Chain stretched(Chain chain, const Rational& factor) {
  for (Point& p : chain) p = factor * p;
  return chain;
}

inline Region stretched(Region region, const Rational& factor) {
  for (Component& component : region.components) {
    component.outer = stretched(component.outer, factor);
    for (Chain& hole : component.holes) hole = stretched(hole, factor);
  }
  return region;
}

/// Requires: factor > 0.
inline MinkowskiSum stretched(MinkowskiSum sum, const Rational& factor) {
  for (auto* chains : {&sum.outer, &sum.holes})
    for (Chain& chain : *chains) chain = stretched(chain, factor);
  for (Segment& edge : sum.dangling_edges) edge = {factor * edge.source, factor * edge.target};
  for (Point& p : sum.isolated_vertices) p = factor * p;
  return sum;
}

/// Turned by a quarter, `times` times.
inline Chain turned(Chain chain, int times) {
  for (; times > 0; --times)
    for (Point& p : chain) p = {-p.y, p.x};
  return chain;
}

inline Region turned(Region region, int times) {
  for (Component& component : region.components) {
    component.outer = turned(component.outer, times);
    for (Chain& hole : component.holes) hole = turned(hole, times);
  }
  return region;
}

}  // namespace oplus
