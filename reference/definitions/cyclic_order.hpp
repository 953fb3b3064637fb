// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "reference/definitions/mutant.hpp"
#include "reference/definitions/rational.hpp"

/// What direction.hpp and tangent_set.hpp declare, over any numbers that `sign` and `cmp` know: the code
/// that runs on rationals is also run on unknowns, to make the formulas of properties/proofs/smt/.
namespace oplus::cyclic_order {

/// 0 for angles in [0, π), 1 for angles in [π, 2π).
template <typename Vector>
int half(const Vector& v) {
  if (OPLUS_MUTANT("left-and-right-are-one-direction",
                   "the directions of the x-axis, positive and negative, are taken for equal"))
    return sign(v.y) < 0 ? 1 : 0;
  return sign(v.y) < 0 || (sign(v.y) == 0 && sign(v.x) < 0) ? 1 : 0;
}

template <typename Vector>
int compare_angle(const Vector& u, const Vector& v) {
  using Number = std::remove_cvref_t<decltype(u.x)>;
  const int halves = half(u) - half(v);
  if (halves != 0) return halves;
  const int in_one_half = cmp(Number(u.y * v.x), Number(u.x * v.y));
  return OPLUS_MUTANT("angles-grow-clockwise",
                      "of two directions of one half plane, the wrong one comes first")
             ? -in_one_half
             : in_one_half;
}

template <typename Direction>
int compare(const Direction& a, const Direction& b) {
  const int angles = compare_angle(a.vector, b.vector);  // of rationals, the one with a contract
  if (angles != 0) return angles;
  const int ties = static_cast<int>(a.of) - static_cast<int>(b.of);
  return OPLUS_MUTANT("ties-go-the-other-way",
                      "of two equal directions, that of P comes after that of Q")
             ? -ties
             : ties;
}

template <typename Direction>
bool counterclockwise_between(const Direction& d, const Direction& from, const Direction& to) {
  const bool after_from = compare(from, d) < 0;
  const bool before_to = compare(d, to) < 0;
  const int range = compare(from, to);
  if (range == 0) return false;
  const bool passes_no_axis =
      OPLUS_MUTANT("between-is-on-the-other-arc",
                   "counterclockwise between is decided as if the range began where it ends")
          ? range > 0
          : range < 0;
  return passes_no_axis ? after_from && before_to : after_from || before_to;
}

template <typename Corner>
bool is_reflex(const Corner& corner) {
  if (OPLUS_MUTANT("acute-vertex-is-reflex",
                   "a vertex with an acute interior angle is taken for reflex") &&
      sign(dot(corner.in, corner.out)) < 0)
    return true;
  return sign(cross(corner.in, corner.out)) < 0;
}

template <typename Direction, typename Corner>
bool in_tangent_set(const Direction& d, const Corner& corner) {
  const Direction in{corner.in, other(d.of)}, out{corner.out, other(d.of)};
  if (OPLUS_MUTANT("tangent-set-without-ties", "equal directions are never in a tangent set") &&
      (compare_angle(d.vector, corner.in) == 0 || compare_angle(d.vector, corner.out) == 0))
    return false;
  if (OPLUS_MUTANT("reflex-turns-clockwise",
                   "a reflex vertex's tangent set is the smaller angle at it") &&
      is_reflex(corner))
    return counterclockwise_between(d, out, in);
  return counterclockwise_between(d, in, out);
}

}  // namespace oplus::cyclic_order
