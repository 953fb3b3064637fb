// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/direction.hpp"

#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

/// 0 for angles in [0, π), 1 for angles in [π, 2π).
int half(const Vector& v) {
  if (OPLUS_MUTANT("left-and-right-are-one-direction")) return sign(v.y) < 0 ? 1 : 0;
  return sign(v.y) < 0 || (sign(v.y) == 0 && sign(v.x) < 0) ? 1 : 0;
}

}  // namespace

int compare_angle(const Vector& u, const Vector& v) {
  OPLUS_REQUIRES(u != (Vector{0, 0}) && v != (Vector{0, 0}), "Definition 2.1.7");
  const int halves = half(u) - half(v);
  return halves != 0 ? halves : cmp(Rational(u.y * v.x), Rational(u.x * v.y));
}

int compare(const Direction& a, const Direction& b) {
  const int angles = compare_angle(a.vector, b.vector);
  return angles != 0 ? angles : static_cast<int>(a.of) - static_cast<int>(b.of);
}

bool counterclockwise_between(const Direction& d, const Direction& from, const Direction& to) {
  const bool after_from = compare(from, d) < 0;
  const bool before_to = compare(d, to) < 0;
  const int range = compare(from, to);
  if (range == 0) return false;
  return range < 0 ? after_from && before_to : after_from || before_to;
}

}  // namespace oplus
