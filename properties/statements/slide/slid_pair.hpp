// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/slide/exact_point.hpp"
#include "checked/slide/free_pieces.hpp"
#include "checked/slide/named_ends.hpp"
#include "checked/slide/reduced_segments.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// A pair as slide prepares it, in 64-bit integers.
struct SlidPair {
  using Numbers = slide::SmallNumbers;
  using Place = slide::Fraction<Numbers>;
  using ReducedSegment = slide::ReducedSegment<Numbers>;
  using Piece = slide::Piece<Numbers>;

  /// Requires: coordinates of at most 29 bits.
  explicit SlidPair(const Summands& pair);

  Point point(std::uint32_t segment, const Place& t) const;

  Vector direction(std::uint32_t segment) const;

  /// x(t), shifted to the right of the segment: by so little that no sign changes that was not
  /// zero.
  Point shifted(std::uint32_t segment, const Place& t) const;

  /// By the definition: whether the interiors of P and -Q + x meet.
  bool interiors_meet_at(const Point& x) const;

  /// A place of each part into which the given places cut the segment, between two of them; the places
  /// need be neither sorted nor different.
  std::vector<Place> between(std::vector<Place> places) const;

  /// What slide finds free, segment by segment.
  slide::ShortList<slide::FreePiece<Numbers>> free_pieces() const;

  const Summands& summands;
  slide::Scaling scaling;
  slide::ReducedSegments<Numbers> segments;

 private:
  Region minus_q_;
};

}  // namespace oplus
