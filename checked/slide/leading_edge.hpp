// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "checked/slide/integer_vector.hpp"
#include "checked/slide/near_number.hpp"

namespace oplus::slide {

struct NearVector {
  NearNumber x, y;

  template <typename Numbers>
  static NearVector of(const IntegerVector<Numbers>& v) {
    return {near_number(v.x), near_number(v.y)};
  }
};

/// A segment by leading digits, each number off by at most 2^-50 of its size: so small ones are as precise as large
/// ones, at both ends.
struct LeadingEdge {
  NearVector source, target, direction;

  template <typename Numbers>
  static LeadingEdge of(const IntegerSegment<Numbers>& s) {
    return {NearVector::of(s.source), NearVector::of(s.source + s.direction),
            NearVector::of(s.direction)};
  }
};

/// The sign of the skew product of d and x - p - q where it is certain, else 0.
inline int certain_side(const NearVector& d, const NearVector& x, const NearVector& p,
                        const NearVector& q) {
  const NearNumber left = d.x * (x.y - p.y - q.y), right = d.y * (x.x - p.x - q.x);
  const NearNumber difference = left - right;
  const NearNumber error =
      NearNumber{1, -48} * (abs(left) + abs(right) + abs(d.x) * (abs(x.y) + abs(p.y) + abs(q.y)) +
                            abs(d.y) * (abs(x.x) + abs(p.x) + abs(q.x)));
  return (error < difference) - (error < -difference);
}

/// Whether a segment is certainly beyond one of the sides of the sum of an edge of P and one of Q, a parallelogram.
inline bool certainly_beyond_a_side(const LeadingEdge& segment, const LeadingEdge& e,
                                    const LeadingEdge& f) {
  const int turn = certain_order(e.direction.x * f.direction.y, e.direction.y * f.direction.x);
  // Of the sides along an edge, whether both ends of the segment are beyond that through a point of the other edge.
  const auto is_beyond = [&](const LeadingEdge& along, const NearVector& through, int side) {
    for (const NearVector* x : {&segment.source, &segment.target})
      if (certain_side(along.direction, *x, along.source, through) != side &&
          certain_side(along.direction, *x, along.target, through) != side)
        return false;
    return true;
  };
  return turn != 0 && (is_beyond(e, f.source, -turn) || is_beyond(e, f.target, turn) ||
                       is_beyond(f, e.source, turn) || is_beyond(f, e.target, -turn));
}

}  // namespace oplus::slide
