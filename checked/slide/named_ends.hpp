// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "checked/slide/boundary_pieces.hpp"
#include "checked/slide/exact_point.hpp"
#include "checked/slide/for_each_number.hpp"
#include "checked/slide/short_list.hpp"
#include "checked/slide/tracks.hpp"

namespace oplus::slide {

/// A free piece of a segment.
template <typename Numbers>
struct FreePiece {
  std::uint32_t segment;
  Piece<Numbers> piece;
};

/// Free pieces, the ends of which have numbers: equal points the same, and all in the order of the plane.
template <typename Numbers>
struct NamedEnds {
  std::vector<ExactPoint<Numbers>> points;
  std::vector<double> near_x, near_y;
  std::vector<BoundaryPiece> pieces;
};

template <typename Numbers>
NamedEnds<Numbers> named_ends(const std::vector<FreePiece<Numbers>>& pieces,
                              const Tracks<Numbers>& tracks, const Scaling& scaling,
                              unsigned threads) {
  struct Place {
    double near_x;
    double near_y;
    std::uint32_t end;
  };
  // End 2 k is the source of piece k, end 2 k + 1 its target.
  ShortList<ExactPoint<Numbers>> ends(2 * pieces.size());
  ShortList<Place> sorted(ends.size());
  for_each_part(pieces.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const IntegerSegment<Numbers> segment = tracks[pieces[k].segment].exact;
      for (std::size_t i = 2 * k; i < 2 * k + 2; ++i) {
        const Piece<Numbers>& piece = pieces[k].piece;
        ends[i] = ExactPoint<Numbers>(segment, i == 2 * k ? piece.from : piece.to);
        sorted[i] = {ends[i].near_x(scaling), ends[i].near_y(scaling),
                     static_cast<std::uint32_t>(i)};
      }
    }
  });
  sort_in_parts(sorted, threads, [](const Place& a, const Place& b) {
    if (a.near_x != b.near_x) return a.near_x < b.near_x;
    if (a.near_y != b.near_y) return a.near_y < b.near_y;
    return a.end < b.end;
  });
  // Equal coordinates are equal in doubles. Where doubles are equal or close and coordinates are not,
  // these decide.
  const auto each_close = [](auto first, auto last, double Place::*near, const auto& visit) {
    while (first != last) {
      auto next = first + 1;
      while (next != last && (*next).*near - (*(next - 1)).*near <=
                                 0x1p-48 * (std::abs((*next).*near) + std::abs((*first).*near)))
        ++next;
      visit(first, next);
      first = next;
    }
  };
  const auto sort_unless = [&](const auto& is_equal, auto first, auto last) {
    const auto& point = ends[first->end];
    if (std::all_of(first + 1, last,
                    [&](const Place& place) { return is_equal(ends[place.end], point); }))
      return true;
    std::sort(first, last,
              [&](const Place& a, const Place& b) { return ends[a.end] < ends[b.end]; });
    return false;
  };
  each_close(sorted.begin(), sorted.end(), &Place::near_x, [&](auto first, auto last) {
    if (!sort_unless([](const auto& a, const auto& b) { return a.has_x_of(b); }, first, last))
      return;
    each_close(first, last, &Place::near_y, [&](auto from, auto to) {
      sort_unless([](const auto& a, const auto& b) { return a == b; }, from, to);
    });
  });
  NamedEnds<Numbers> named;
  named.pieces.resize(pieces.size());
  named.points.reserve(pieces.size() + 8);
  named.near_x.reserve(pieces.size() + 8);
  named.near_y.reserve(pieces.size() + 8);
  for (const Place& place : sorted) {
    ExactPoint<Numbers>& point = ends[place.end];
    if (named.points.empty() || !(named.points.back() == point)) {
      named.points.push_back(std::move(point));
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
