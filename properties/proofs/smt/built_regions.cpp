// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/built_regions.hpp"

#include <algorithm>

namespace oplus::smt {

namespace {

/// Those of the axes that are strictly between two directions, counterclockwise: so that no two
/// neighbours are apart by more than a right angle, but where the two are themselves.
std::vector<Vector> axes_between(const Vector& from, const Vector& to) {
  std::vector<Vector> axes;
  for (const Vector& axis : {Vector{1, 0}, Vector{0, 1}, Vector{-1, 0}, Vector{0, -1}})
    if (counterclockwise_between({axis, Summand::P}, {from, Summand::P}, {to, Summand::P}))
      axes.push_back(axis);
  const auto first = std::find_if(
      axes.begin(), axes.end(), [&](const Vector& axis) { return compare_angle(from, axis) < 0; });
  std::rotate(axes.begin(), first, axes.end());
  return axes;
}

}  // namespace

Region region_with_corner(const Corner& corner) {
  const Vector back = -corner.in;
  Chain chain = {{0, 0}, corner.out};
  for (const Vector& axis : axes_between(corner.out, back)) chain.push_back(axis);
  chain.push_back(back);
  return polygon(chain);
}

Region region_with_edge(const Vector& edge, const Rational& radius) {
  const Rational length = abs(edge.x) + abs(edge.y);
  // Between two vectors that are at most a right angle apart the sides keep at least half as far off
  // as the shorter of them, by the sum of coordinates.
  const Rational far = 4 * radius;
  Chain chain = {far / length * edge};
  for (const Vector& axis : axes_between(edge, -edge)) chain.push_back(far * axis);
  chain.push_back(-(far / length) * edge);
  return polygon(chain);
}

}  // namespace oplus::smt
