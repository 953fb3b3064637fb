// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/values.hpp"

namespace oplus {

/// How far two sets are from each other, and where.
struct NearestPoints {
  Rational squared_distance;  ///< 0 where they have a common point
  Point on_p;                 ///< a point of P,
  Point on_q;                 ///< and one of Q, at that distance from each other
};

/// A shortest way out of an overlap.
struct Overlap {
  Vector move;             ///< of Q; no shorter one ends the overlap
  Rational squared_depth;  ///< the square of its length
  Point contact;  ///< a point that P and Q + move have in common; their interiors have none
};

}  // namespace oplus
