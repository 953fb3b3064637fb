// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "reference/definitions/direction.hpp"
#include "reference/families/circle_point.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

constexpr int largest_radius = 1'000'000;

struct ByAngle {
  bool operator()(const Vector& u, const Vector& v) const { return compare_angle(u, v) < 0; }
};

/// Whether each turn about the origin is left, so that the origin is inside and sees every vertex.
bool winds_around_origin(const Chain& chain) {
  const std::vector<Segment> of_chain = edges(chain);
  return std::all_of(of_chain.begin(), of_chain.end(),
                     [](const Segment& e) { return sign(cross(e.source, e.target)) > 0; });
}

}  // namespace

Region star_polygon(Random& random, std::size_t n) {
  while (true) {
    std::set<Vector, ByAngle> rays;  // of two in the same direction it keeps one
    while (rays.size() < n) {
      const int radius = uniform(random, 1, largest_radius);
      const Point end = circle_point(random, radius);
      if (end != (Point{0, 0})) rays.insert(end);
    }
    const Chain chain(rays.begin(), rays.end());
    if (winds_around_origin(chain)) return polygon(chain);
  }
}

}  // namespace oplus
