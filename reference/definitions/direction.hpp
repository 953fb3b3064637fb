// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/point.hpp"

namespace oplus {

inline Summand other(Summand s) { return s == Summand::P ? Summand::Q : Summand::P; }

/// A direction (thesis, Definition 2.1.7: a nonzero vector up to positive scaling), together with
/// the summand it belongs to, which decides ties.
struct Direction {
  Vector vector;
  Summand of;
};

/// Compares the angles of u and v from the positive x-axis, counterclockwise, in [0, 2π).
/// Returns a negative number, zero or a positive number. Requires: u and v are not zero.
int compare_angle(const Vector& u, const Vector& v);

/// Whether u and v are equal as directions.
inline bool same_direction(const Vector& u, const Vector& v) { return compare_angle(u, v) == 0; }

/// The tie rule (thesis, Definition 2.2.7): compares by angle; of two equal directions, that of Q
/// counts as turned counterclockwise by an infinitesimal, so it comes after that of P.
int compare(const Direction& a, const Direction& b);

/// CCW(d, from, to) (thesis, Definitions 2.1.10 and 2.1.11): turning counterclockwise from
/// `from`, d is met before `to`. Never true for d equal to `from` or `to`, nor where those two
/// are equal.
bool counterclockwise_between(const Direction& d, const Direction& from, const Direction& to);

}  // namespace oplus
