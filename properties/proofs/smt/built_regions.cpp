// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/built_regions.hpp"

#include <algorithm>

namespace oplus::smt {

namespace {

/// The directions of the axes strictly between two directions, counterclockwise. Together with the
/// two, neighbours are at most a right angle apart if there is such a direction.
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
  if (same_direction(corner.out, back)) return {};
  Chain chain = {{0, 0}, corner.out};
  for (const Vector& axis : axes_between(corner.out, back)) chain.push_back(axis);
  chain.push_back(back);
  return polygon(chain);
}

Region region_with_edge(const Vector& edge, const Rational& radius) {
  const Rational length = abs(edge.x) + abs(edge.y);
  // A side between two vectors at most a right angle apart has at least half the distance of the
  // shorter one from the origin, in the norm |x| + |y|.
  const Rational far = 4 * radius;
  Chain chain = {far / length * edge};
  for (const Vector& axis : axes_between(edge, -edge)) chain.push_back(far * axis);
  chain.push_back(-(far / length) * edge);
  return polygon(chain);
}

}  // namespace oplus::smt
