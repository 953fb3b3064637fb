// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "checked/slide/fraction.hpp"
#include "checked/slide/integer_vector.hpp"

namespace oplus::slide {

/// Cuts a piece to where low <= constant + t slope <= high. Returns whether something is left.
template <typename Numbers>
bool cut(Piece<Numbers>& piece, const typename Numbers::Value& constant,
         const typename Numbers::Value& slope, const typename Numbers::Value& low,
         const typename Numbers::Value& high) {
  if (slope == 0) return low <= constant && constant <= high;
  using Value = typename Numbers::Value;
  const auto place = [&](const Value& side) {
    return slope > 0 ? Fraction<Numbers>{Value(side - constant), slope}
                     : Fraction<Numbers>{Value(constant - side), Value(-slope)};
  };
  const Fraction<Numbers> from = place(slope > 0 ? low : high), to = place(slope > 0 ? high : low);
  if (piece.from < from) piece.from = from;
  if (to < piece.to) piece.to = to;
  return !(piece.to < piece.from);
}

/// The places on a segment at which an edge of P and one of -Q + x(t) have a point in common: where
/// x(t) is in the closed sum of the edge of P and that of Q, a parallelogram. None for parallel edges:
/// where they begin or end to touch, so does one of them and a neighbour of the other.
template <typename Numbers>
std::optional<Piece<Numbers>> contact_interval(const IntegerSegment<Numbers>& segment,
                                               const IntegerSegment<Numbers>& of_p,
                                               const IntegerSegment<Numbers>& of_q) {
  using Value = typename Numbers::Value;
  const auto& u = of_p.direction;
  const auto& w = of_q.direction;
  const auto& d = segment.direction;
  const Value area = cross(u, w);
  if (area == 0) return std::nullopt;
  const auto from_corner = segment.source - of_p.source - of_q.source;
  const Value zero = 0;
  const Value low = std::min(area, zero), high = std::max(area, zero);
  Piece<Numbers> piece{{0, 1}, {1, 1}};
  // The corner, plus a u + b w, where 0 <= a <= 1 and 0 <= b <= 1.
  if (!cut<Numbers>(piece, cross(from_corner, w), cross(d, w), low, high)) return std::nullopt;
  if (!cut<Numbers>(piece, cross(u, from_corner), cross(u, d), low, high)) return std::nullopt;
  return piece;
}

}  // namespace oplus::slide
