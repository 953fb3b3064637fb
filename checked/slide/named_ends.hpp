// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "checked/slide/boundary_pieces.hpp"
#include "checked/slide/exact_point.hpp"
#include "checked/slide/short_list.hpp"
#include "checked/slide/tracks.hpp"

namespace oplus::slide {

/// A free piece of a segment.
template <typename Numbers>
struct FreePiece {
  std::uint32_t segment;
  Piece<Numbers> piece;
};

/// Free pieces, the ends of which have numbers: equal points the same.
template <typename Numbers>
struct NamedEnds {
  ShortList<ExactPoint<Numbers>> points;
  std::vector<double> near_x, near_y;
  std::vector<BoundaryPiece> pieces;
};

template <typename Numbers>
NamedEnds<Numbers> named_ends(const ShortList<FreePiece<Numbers>>& pieces,
                              const Tracks<Numbers>& tracks, const Scaling& scaling) {
  // End 2 k is the source of piece k, end 2 k + 1 its target.
  ShortList<ExactPoint<Numbers>> ends;
  ends.reserve(2 * pieces.size());
  for (const FreePiece<Numbers>& piece : pieces) {
    const IntegerSegment<Numbers> segment = tracks[piece.segment].exact;
    ends.emplace_back(segment, piece.piece.from);
    ends.emplace_back(segment, piece.piece.to);
  }
  // Equal points are equal in doubles, too, and those are faster to sort.
  struct Place {
    double near_x;
    double near_y;
    std::uint32_t end;
  };
  ShortList<Place> sorted;
  sorted.reserve(ends.size());
  for (std::uint32_t i = 0; i < ends.size(); ++i)
    sorted.push_back({ends[i].near_x(scaling), ends[i].near_y(scaling), i});
  std::sort(sorted.begin(), sorted.end(), [&](const Place& a, const Place& b) {
    if (a.near_x != b.near_x) return a.near_x < b.near_x;
    if (a.near_y != b.near_y) return a.near_y < b.near_y;
    return ends[a.end] < ends[b.end];
  });
  NamedEnds<Numbers> named;
  named.pieces.resize(pieces.size());
  named.points.reserve(pieces.size() + 8);
  named.near_x.reserve(pieces.size() + 8);
  named.near_y.reserve(pieces.size() + 8);
  for (const Place& place : sorted) {
    const ExactPoint<Numbers>& point = ends[place.end];
    if (named.points.empty() || !(named.points.back() == point)) {
      named.points.push_back(point);
      named.near_x.push_back(place.near_x);
      named.near_y.push_back(place.near_y);
    }
    const auto name = static_cast<std::uint32_t>(named.points.size() - 1);
    BoundaryPiece& piece = named.pieces[place.end / 2];
    (place.end % 2 == 0 ? piece.from : piece.to) = name;
    piece.segment = pieces[place.end / 2].segment;
  }
  return named;
}

}  // namespace oplus::slide
