// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "checked/slide/boundary_pieces.hpp"
#include "checked/slide/exact_point.hpp"
#include "checked/slide/parallel_for.hpp"
#include "checked/slide/reduced_segments.hpp"
#include "checked/slide/short_list.hpp"

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
  ShortList<ExactPoint<Numbers>> points;
  ShortList<double> near_x, near_y;
  ShortList<BoundaryPiece> pieces;
};

template <typename Numbers>
NamedEnds<Numbers> named_ends(ShortList<FreePiece<Numbers>> pieces,
                              const ReducedSegments<Numbers>& segments, const Scaling& scaling,
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
      const IntegerSegment<Numbers> segment = segments.exact(pieces[k].segment);
      for (std::size_t i = 2 * k; i < 2 * k + 2; ++i) {
        const Piece<Numbers>& piece = pieces[k].piece;
        ends[i] = ExactPoint<Numbers>(segment, i == 2 * k ? piece.from : piece.to);
        sorted[i] = {ends[i].near_x(scaling), ends[i].near_y(scaling),
                     static_cast<std::uint32_t>(i)};
      }
    }
  });
  NamedEnds<Numbers> named;
  named.pieces.resize(pieces.size());
  for (std::size_t k = 0; k < pieces.size(); ++k) named.pieces[k].segment = pieces[k].segment;
  pieces = {};  // which take much memory
  sort_in_parts(sorted, threads, [](const Place& a, const Place& b) {
    if (a.near_x != b.near_x) return a.near_x < b.near_x;
    if (a.near_y != b.near_y) return a.near_y < b.near_y;
    return a.end < b.end;
  });
  const auto is_close = [](double a, double b) {
    return b - a <= 0x1p-48 * (std::abs(b) + std::abs(a));
  };
  // Whether each has the x of the one before, and whether it is the same point.
  ShortList<char> same_x(ends.size()), same(ends.size());
  const auto compare = [&](std::size_t first, std::size_t last) {
    for (std::size_t k = std::max<std::size_t>(first, 1); k < last; ++k) {
      const ExactPoint<Numbers>& a = ends[sorted[k - 1].end];
      const ExactPoint<Numbers>& b = ends[sorted[k].end];
      same_x[k] = is_close(sorted[k - 1].near_x, sorted[k].near_x) && a.has_x_of(b);
      same[k] = same_x[k] && a.has_y_of(b);
    }
  };
  for_each_part(ends.size(), threads, compare);
  // Equal coordinates are close in doubles. Where doubles are close and coordinates are not equal, or the
  // other way round, coordinates decide.
  const auto each_close = [&](std::size_t first, std::size_t last, double Place::*near,
                              const auto& visit) {
    while (first < last) {
      std::size_t next = first + 1;
      while (next < last && is_close(sorted[next - 1].*near, sorted[next].*near)) ++next;
      visit(first, next);
      first = next;
    }
  };
  const auto at = [](auto& list, std::size_t k) {
    return list.begin() + static_cast<std::ptrdiff_t>(k);
  };
  const auto are_all = [&](const ShortList<char>& equal, std::size_t first, std::size_t last) {
    return std::find(at(equal, first + 1), at(equal, last), false) == at(equal, last);
  };
  const auto sort = [&](std::size_t first, std::size_t last) {
    std::sort(at(sorted, first), at(sorted, last),
              [&](const Place& a, const Place& b) { return ends[a.end] < ends[b.end]; });
    compare(first + 1, last);
  };
  each_close(0, sorted.size(), &Place::near_x, [&](std::size_t first, std::size_t last) {
    if (sorted[first].near_x != sorted[last - 1].near_x || !are_all(same_x, first, last))
      return sort(first, last);
    each_close(first, last, &Place::near_y, [&](std::size_t from, std::size_t to) {
      if (!are_all(same, from, to)) sort(from, to);
    });
  });
  ShortList<std::uint32_t> names(ends.size());
  std::uint32_t different = 0;
  for (std::size_t k = 0; k < names.size(); ++k) names[k] = (different += !same[k]) - 1;
  named.points.resize(different);
  named.near_x.resize(different);
  named.near_y.resize(different);
  for_each_part(ends.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const auto& [near_x, near_y, end] = sorted[k];
      BoundaryPiece& piece = named.pieces[end / 2];
      (end % 2 == 0 ? piece.from : piece.to) = names[k];
      if (same[k]) continue;
      named.points[names[k]] = std::move(ends[end]);
      named.near_x[names[k]] = near_x;
      named.near_y[names[k]] = near_y;
    }
  });
  return named;
}

}  // namespace oplus::slide
