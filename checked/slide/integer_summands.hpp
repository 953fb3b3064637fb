// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "checked/slide/component_tree.hpp"
#include "checked/slide/fraction.hpp"
#include "checked/slide/integer_summand.hpp"
#include "checked/slide/pair_table.hpp"

namespace oplus::slide {

/// Up to so many pairs of edges, comparing all of them is faster than boxes.
constexpr std::size_t few_pairs = 512;

/// Whether a summand is convex.
template <typename Numbers>
bool is_convex(const IntegerSummand<Numbers>& summand) {
  if (summand.first_of_chain.size() > 1) return false;
  for (std::uint32_t i = 0; i < summand.edges.size(); ++i) {
    const auto& entering = summand.edges[summand.previous[i]];
    if (sign_of(cross(entering.direction, summand.edges[i].direction)) < 0) return false;
  }
  return true;
}

/// Both summands, and either all pairs of their edges or their boxes.
template <typename Numbers>
struct IntegerSummands {
  IntegerSummands(const Region& region_p, const Region& region_q, const Scaling& scaling,
                  std::size_t most_pairs = few_pairs)
      : p(integer_summand<Numbers>(region_p, scaling, scaling.of_p)),
        q(integer_summand<Numbers>(region_q, scaling, scaling.of_q)),
        pairs(p.near, q.near, most_pairs),
        margins(slide::margins(scaling)) {
    if (pairs.is_empty()) {
      prepare_boxes();
      prepare_cover();
    }
    if (has_several_components()) prepare_component_test();
  }

  IntegerSummand<Numbers> p;
  IntegerSummand<Numbers> q;
  PairTable pairs;
  BoxTree tree_of_p;
  BoxTree tree_of_q;
  Margins margins;
  /// Empty unless there are several components.
  ComponentTree components_of_p = {};
  ComponentTree components_of_q = {};

  /// That of the two which is convex, if it has few edges and there are boxes: see ConvexCover.
  std::optional<Summand> convex = {};

  bool has_several_components() const {
    return p.first_of_component.size() > 2 || q.first_of_component.size() > 2;
  }
  void prepare_boxes() {
    tree_of_p = box_tree(p);
    tree_of_q = box_tree(q);
  }
  void prepare_cover() {
    constexpr std::size_t most_edges = 128;  // each is looked at for each box
    const auto is_fit = [](const auto& summand) {
      return summand.edges.size() <= most_edges && is_convex(summand);
    };
    const bool of_p = is_fit(p), of_q = is_fit(q);
    if (of_p != of_q) convex = of_p ? Summand::P : Summand::Q;
  }
  void prepare_component_test() {
    components_of_p = ComponentTree(p);
    components_of_q = ComponentTree(q);
  }
};

/// The numbers of an edge of P and one of Q.
using EdgePair = std::pair<std::uint32_t, std::uint32_t>;

/// A segment of the convolution, exactly and in doubles.
template <typename Numbers>
struct Track {
  IntegerSegment<Numbers> exact;
  NearSegment near;
  double error;  ///< more than a place on it in doubles can be off
  /// The edge that touches, with both edges at the vertex that touches it.
  std::array<EdgePair, 2> contact = {};
};

/// Of the places on the sum of an edge and a vertex, and on the line of the segment as far as it goes.
inline double error_of_places(const NearSegment& edge, const NearSegment& vertex) {
  return 0x1p-49 * (std::abs(edge.x) + std::abs(edge.y) + std::abs(edge.dx) + std::abs(edge.dy) +
                    std::abs(vertex.x) + std::abs(vertex.y)) +
         0x1p-400;
}

template <typename Numbers>
NearPoint near_place(const Track<Numbers>& track, const Fraction<Numbers>& t) {
  const double near_t = t.near();
  return {track.near.x + near_t * track.near.dx, track.near.y + near_t * track.near.dy,
          track.error};
}

/// A place on a track along an axis, moved to its right by less than there is between integers: so it
/// leaves those boxes around integers that it only touches.
template <typename Numbers>
NearPoint shifted_to_the_right(const Track<Numbers>& track, NearPoint place) {
  constexpr double part = 0.25;
  if (track.near.dx == 0) place.x += track.near.dy > 0 ? part : -part;
  if (track.near.dy == 0) place.y += track.near.dx > 0 ? -part : part;
  return place;
}

/// The source of an edge, off by at most a rounding.
inline NearPoint near_source(const NearSegment& edge) {
  return {edge.x, edge.y, 0x1p-50 * (std::abs(edge.x) + std::abs(edge.y)) + 0x1p-400};
}

/// A place less the source of an edge.
inline NearPoint difference(const NearPoint& place, const NearSegment& edge) {
  const NearPoint source = near_source(edge);
  return {place.x - source.x, place.y - source.y,
          place.error + source.error + 0x1p-50 * (std::abs(place.x) + std::abs(place.y))};
}

}  // namespace oplus::slide
