// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "checked/slide/integer_vector.hpp"
#include "checked/slide/near_number.hpp"

namespace oplus::slide {

struct NearVector {
  NearNumber x, y;

  template <typename Numbers>
  static NearVector of(const IntegerVector<Numbers>& v) {
    return {near_number(v.x), near_number(v.y)};
  }
  friend NearVector operator+(const NearVector& a, const NearVector& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend NearVector operator-(const NearVector& a, const NearVector& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend NearVector operator*(const NearNumber& t, const NearVector& v) {
    return {t * v.x, t * v.y};
  }
};

/// An edge by leading digits, each number off by at most 2^-50 of its size: so small ones are as precise as large
/// ones, at both ends.
struct LeadingEdge {
  NearVector source, target, direction;

  template <typename Numbers>
  static LeadingEdge of(const IntegerSegment<Numbers>& s) {
    return {NearVector::of(s.source), NearVector::of(s.source + s.direction),
            NearVector::of(s.direction)};
  }
};

/// Larger than the size of a number is a power of two with this exponent. Requires: its mantissa is less than 2.
inline long bits_of(const NearNumber& a) {
  constexpr long of_zero = std::numeric_limits<long>::min() / 8;
  return a.mantissa == 0 ? of_zero : a.exponent + 1;
}

/// A vector by leading digits, each of its two numbers off by at most 2^(bits - 48).
struct LeadingVector {
  NearVector near{};
  long bits_x = bits_of({}), bits_y = bits_of({});

  /// Of a vector whose numbers are off by at most 2^-49 of their size.
  static LeadingVector of(const NearVector& v) { return {v, bits_of(v.x), bits_of(v.y)}; }

  /// Of two vertices, 0 where they are the same, however large they are: what is left of a sum of differences is then
  /// as precise as its small terms.
  static LeadingVector difference(const NearVector& a, const NearVector& b, bool is_same) {
    if (is_same) return {};
    return {a - b, std::max(bits_of(a.x), bits_of(b.x)) + 1,
            std::max(bits_of(a.y), bits_of(b.y)) + 1};
  }
  friend LeadingVector operator+(const LeadingVector& a, const LeadingVector& b) {
    return {a.near + b.near, std::max(a.bits_x, b.bits_x) + 1, std::max(a.bits_y, b.bits_y) + 1};
  }
};

/// The sign of the skew product of d and v where it is certain, else 0.
inline int certain_side(const NearVector& d, const LeadingVector& v) {
  const NearNumber difference = d.x * v.near.y - d.y * v.near.x;
  // It is off by at most 2^(bits - 46), and of at least an eighth of the power of two with its exponent.
  const long bits = std::max(bits_of(d.x) + v.bits_y, bits_of(d.y) + v.bits_x);
  if (difference.mantissa == 0 || difference.exponent <= bits - 43) return 0;
  return difference.mantissa > 0 ? 1 : -1;
}

/// A place on a segment of the convolution, seen from an edge of P and one of Q: less the source, and the target, of
/// the edge of P, and of Q; the sum of one of each and of `along`, the place less an end of the segment.
struct LeadingPlace {
  std::array<LeadingVector, 2> from_p, from_q;
  LeadingVector along;
};

/// The direction of such an edge, and whether the segment is parallel to it for being its sum with a vertex.
struct LeadingDirection {
  NearVector direction;
  bool is_of_segment;
};

/// Whether places on a segment, and all between them, are certainly beyond one of the sides of the sum of an edge
/// of P and one of Q, a parallelogram.
inline bool certainly_beyond_a_side(std::span<const LeadingPlace> places, const LeadingDirection& p,
                                    const LeadingDirection& q) {
  const int turn = certain_order(p.direction.x * q.direction.y, p.direction.y * q.direction.x);
  // Of the sides along one edge, whether both places are beyond that through an end of the other.
  const auto is_beyond = [&](bool along_p, std::size_t end, int side) {
    const LeadingDirection& edge = along_p ? p : q;
    return std::all_of(places.begin(), places.end(), [&](const LeadingPlace& place) {
      const LeadingVector& from_end = (along_p ? place.from_q : place.from_p)[end];
      const LeadingVector rest = edge.is_of_segment ? from_end : from_end + place.along;
      // Seen from either end of the edge: from one of them, there may be no large number.
      const auto& from_edge = along_p ? place.from_p : place.from_q;
      return std::any_of(from_edge.begin(), from_edge.end(), [&](const LeadingVector& of_edge) {
        return certain_side(edge.direction, of_edge + rest) == side;
      });
    });
  };
  return turn != 0 && (is_beyond(true, 0, -turn) || is_beyond(true, 1, turn) ||
                       is_beyond(false, 0, turn) || is_beyond(false, 1, -turn));
}

/// Axis-parallel, around vertices.
struct LeadingBox {
  NearVector low, high;

  static LeadingBox of(const NearVector& vertex) { return {vertex, vertex}; }
  /// The smallest one around two.
  friend LeadingBox around(const LeadingBox& a, const LeadingBox& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
  }
  /// The corner whose skew product with d is the largest, or the least.
  NearVector corner(const NearVector& d, bool largest) const {
    if (OPLUS_MUTANT(
            "slide-takes-the-other-corner",
            "the corner of a box by leading digits that is nearest to a line tells what is beyond it"))
      largest = !largest;
    return {(d.y.mantissa < 0) == largest ? high.x : low.x,
            (d.x.mantissa < 0) == largest ? low.y : high.y};
  }
};

/// A place as LeadingPlace is one, of which one end of the segment is the sum of `vertex` and a vertex of the other
/// summand, and this one is seen from an edge.
struct LeadingPlaceByBox {
  NearVector vertex;
  std::array<LeadingVector, 2> from_edge;
  LeadingVector along;
};

/// The same for the sum of a box around the vertices of one summand and an edge of the other one, a hexagon.
inline bool certainly_beyond_a_side(std::span<const LeadingPlaceByBox> places,
                                    const LeadingBox& box, const LeadingDirection& edge) {
  const auto is_beyond = [&](const LeadingDirection& along, int side, bool of_edge) {
    const NearVector corner = box.corner(along.direction, side > 0);
    return std::all_of(places.begin(), places.end(), [&](const LeadingPlaceByBox& place) {
      const LeadingVector from_corner = LeadingVector::difference(place.vertex, corner, false);
      const LeadingVector rest = along.is_of_segment ? from_corner : from_corner + place.along;
      const auto is_on_side = [&](const LeadingVector& from_end) {
        return certain_side(along.direction, from_end + rest) == side;
      };
      // Along the edge, one of its ends tells what both do.
      return of_edge ? is_on_side(place.from_edge[0]) || is_on_side(place.from_edge[1])
                     : is_on_side(place.from_edge[0]) && is_on_side(place.from_edge[1]);
    });
  };
  constexpr NearNumber zero{0, 0}, one{0.5, 1};
  const LeadingDirection x{{one, zero}, false}, y{{zero, one}, false};
  return is_beyond(edge, 1, true) || is_beyond(edge, -1, true) || is_beyond(x, 1, false) ||
         is_beyond(x, -1, false) || is_beyond(y, 1, false) || is_beyond(y, -1, false);
}

}  // namespace oplus::slide
