// SPDX-License-Identifier: MIT
#include "reference/definitions/signed_crossings.hpp"

#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

/// The sign of [v, (ε, ε²)] for an infinitesimal ε > 0. Requires: v is not zero.
int turn_to_shift(const Vector& v) {
  if (OPLUS_MUTANT(
          "steps-are-not-shifted",
          "a step through a vertex or along a segment counts points on a line as to its left"))
    return 1;
  return sign(v.y) != 0 ? -sign(v.y) : sign(v.x);
}

}  // namespace

int signed_crossing(const Point& from, const Point& to, const Segment& s) {
  const auto side_of_s = [&](const Point& p) {
    const int side = orientation(s.source, s.target, p);
    return side != 0 ? side : turn_to_shift(direction_of(s));
  };
  const auto side_of_path = [&](const Point& p) {
    const int side = orientation(from, to, p);
    return side != 0 ? side : -turn_to_shift(to - from);
  };
  const int before = side_of_s(from), after = side_of_s(to);
  if (before == after || side_of_path(s.source) == side_of_path(s.target)) return 0;
  return after;
}

int signed_crossings(const std::vector<Point>& path, const std::vector<Segment>& segments) {
  int sum = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    if (path[k] == path[k + 1]) continue;
    for (const Segment& s : segments) sum += signed_crossing(path[k], path[k + 1], s);
  }
  return sum;
}

}  // namespace oplus
