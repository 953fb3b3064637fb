// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/tangent_set.hpp"

#include "reference/definitions/mutant.hpp"

namespace oplus {

bool is_reflex(const Corner& corner) {
  if (OPLUS_MUTANT("acute-vertex-is-reflex") && sign(dot(corner.in, corner.out)) < 0) return true;
  return sign(cross(corner.in, corner.out)) < 0;
}

bool in_tangent_set(const Direction& d, const Corner& corner) {
  const Summand of = other(d.of);
  if (OPLUS_MUTANT("tangent-set-without-ties") &&
      (same_direction(d.vector, corner.in) || same_direction(d.vector, corner.out)))
    return false;
  if (OPLUS_MUTANT("reflex-turns-clockwise") && is_reflex(corner))
    return counterclockwise_between(d, {corner.out, of}, {corner.in, of});
  return counterclockwise_between(d, {corner.in, of}, {corner.out, of});
}

}  // namespace oplus
