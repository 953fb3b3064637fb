// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

struct Box {
  int left, bottom, right, top;
};

Box inset(Random& random, const Box& box, int least, int most) {
  return {box.left + uniform(random, least, most), box.bottom + uniform(random, least, most),
          box.right - uniform(random, least, most), box.top - uniform(random, least, most)};
}

/// A box, each corner cut off by one or not. Boxes inset by one stay inside it.
Chain box_with_cut_corners(Random& random, const Box& box) {
  Chain chain;
  const auto corner = [&](const Point& at, const Vector& before, const Vector& after) {
    if (one_in(random, 3)) {
      chain.push_back(at + before);
      chain.push_back(at + after);
    } else {
      chain.push_back(at);
    }
  };
  corner({box.left, box.bottom}, {0, 1}, {1, 0});
  corner({box.right, box.bottom}, {-1, 0}, {0, 1});
  corner({box.right, box.top}, {0, -1}, {-1, 0});
  corner({box.left, box.top}, {1, 0}, {0, -1});
  return chain;
}

}  // namespace

/// Moats about as wide as Q is, often exactly.
Summands islands_pair(Random& random, std::size_t n) {
  const int width = uniform(random, 1, 2);
  Region q = convex_grid_polygon(random, 4, width + 1);
  const int rings = uniform(random, 1, static_cast<int>(n));
  const int most = width + 2;
  const int side = 4 + 4 * rings * most;
  Region p;
  Box box{0, 0, side, side};
  for (int ring = 0; ring < rings; ++ring) {
    Component component{box_with_cut_corners(random, box), {}};
    box = inset(random, box, 1, 2);
    const Chain hole = box_with_cut_corners(random, box);
    component.holes.emplace_back(hole.rbegin(), hole.rend());
    p.components.push_back(std::move(component));
    box = inset(random, box, std::max(width - 1, 1), most);
  }
  p.components.push_back({box_with_cut_corners(random, box), {}});
  return {std::move(p), std::move(q)};
}

}  // namespace oplus
