// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>

#include "checked/slide/fraction.hpp"
#include "checked/slide/integer_summand.hpp"
#include "checked/slide/pair_table.hpp"

namespace oplus::slide {

/// Up to so many pairs of edges, comparing all of them is faster than boxes.
constexpr std::size_t few_pairs = 512;

/// Both summands, and either all pairs of their edges or their boxes.
template <typename Numbers>
struct IntegerSummands {
  IntegerSummands(const Region& region_p, const Region& region_q, const Scaling& scaling,
                  std::size_t most_pairs = few_pairs)
      : p(integer_summand<Numbers>(region_p, scaling, scaling.of_p)),
        q(integer_summand<Numbers>(region_q, scaling, scaling.of_q)),
        pairs(p.near, q.near, most_pairs),
        margins(slide::margins(scaling)) {
    if (!pairs.is_empty()) return;
    tree_of_p = box_tree(p);
    tree_of_q = box_tree(q);
  }

  IntegerSummand<Numbers> p;
  IntegerSummand<Numbers> q;
  PairTable pairs;
  BoxTree tree_of_p;
  BoxTree tree_of_q;
  Margins margins;
};

/// The numbers of an edge of P and one of Q.
using EdgePair = std::pair<std::uint32_t, std::uint32_t>;

/// A segment of the convolution, exactly and in doubles.
template <typename Numbers>
struct Track {
  IntegerSegment<Numbers> exact;
  NearSegment near;
  /// The edge that touches, with both edges at the vertex that touches it.
  std::array<EdgePair, 2> contact = {};
};

template <typename Numbers>
NearPoint near_place(const Track<Numbers>& track, const Fraction<Numbers>& t) {
  const double near_t = t.near();
  return {track.near.x + near_t * track.near.dx, track.near.y + near_t * track.near.dy};
}

}  // namespace oplus::slide
