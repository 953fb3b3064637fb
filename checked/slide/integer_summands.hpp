// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "checked/slide/fraction.hpp"
#include "checked/slide/kept_summand.hpp"
#include "checked/slide/pair_table.hpp"

namespace oplus::slide {

/// Up to so many pairs of edges, comparing all of them is faster than boxes.
constexpr std::size_t few_pairs = 512;

/// Both summands, and either all pairs of their edges or their boxes.
template <typename Numbers>
struct IntegerSummands {
 private:
  // Unless they are somebody else's; before what refers to them.
  std::optional<KeptSummand<Numbers>> own_p_, own_q_;
  const KeptSummand<Numbers>& kept_p_;
  const KeptSummand<Numbers>& kept_q_;

 public:
  IntegerSummands(const Region& region_p, const Region& region_q, const Scaling& scaling,
                  std::size_t most_pairs = few_pairs)
      : own_p_(std::in_place, region_p, scaling, scaling.of_p),
        own_q_(std::in_place, region_q, scaling, scaling.of_q),
        kept_p_(*own_p_),
        kept_q_(*own_q_),
        pairs(span_of(p.near), span_of(q.near), most_pairs),
        margins(slide::margins(scaling)) {
    prepare();
  }

  /// Requires: both are in this scaling, and outlive it.
  IntegerSummands(const KeptSummand<Numbers>& kept_p, const KeptSummand<Numbers>& kept_q,
                  const Scaling& scaling)
      : kept_p_(kept_p),
        kept_q_(kept_q),
        pairs(span_of(p.near), span_of(q.near), few_pairs),
        margins(slide::margins(scaling)) {
    prepare();
  }

  IntegerSummands(const IntegerSummands&) = delete;
  IntegerSummands& operator=(const IntegerSummands&) = delete;

  const IntegerSummand<Numbers>& p = kept_p_.summand();
  const IntegerSummand<Numbers>& q = kept_q_.summand();
  PairTable pairs;
  /// Empty before prepare_boxes().
  const FloatBoxTree& tree_of_p = kept_p_.boxes();
  const FloatBoxTree& tree_of_q = kept_q_.boxes();
  /// By the nodes of the trees, where numbers may be out of the range of doubles, else empty.
  const std::vector<LeadingBox>& leading_boxes_of_p = kept_p_.leading_boxes();
  const std::vector<LeadingBox>& leading_boxes_of_q = kept_q_.leading_boxes();
  Margins margins;
  /// Empty unless there are several components.
  const ComponentTree& components_of_p = kept_p_.components();
  const ComponentTree& components_of_q = kept_q_.components();

  /// That of the two which is convex, if it has few edges and there are boxes: see ConvexCover.
  std::optional<Summand> convex = {};

  bool has_several_components() const {
    return p.first_of_component.size() > 2 || q.first_of_component.size() > 2;
  }
  void prepare_boxes(unsigned threads = 1) const {
    kept_p_.prepare_boxes(threads);
    kept_q_.prepare_boxes(threads);
  }
  void drop_boxes() {
    if (own_p_) own_p_->drop_boxes();
    if (own_q_) own_q_->drop_boxes();
  }
  void prepare_component_test() {
    kept_p_.prepare_components();
    kept_q_.prepare_components();
  }

 private:
  void prepare() {
    if (pairs.is_empty()) {
      const bool of_p = kept_p_.is_fit_to_cover(), of_q = kept_q_.is_fit_to_cover();
      if (of_p != of_q) convex = of_p ? Summand::P : Summand::Q;
    }
    if (has_several_components()) prepare_component_test();
  }
};

/// The numbers of an edge of P and one of Q.
using EdgePair = std::pair<std::uint32_t, std::uint32_t>;

/// A segment of the convolution, exactly and in doubles.
template <typename Numbers>
struct ReducedSegment {
  IntegerSegment<Numbers> exact;
  NearSegment near;
  double error;  ///< more than a place on it in doubles can be off
  /// The edge that touches, with both edges at the vertex that touches it.
  std::array<EdgePair, 2> contact = {};

  /// Not of touching points, whose contacts are the same.
  bool edge_is_of_p() const { return contact[0].first == contact[1].first; }
};

/// Of the places on the sum of an edge and a vertex, and on the line of the segment as far as it goes.
inline double error_of_places(const NearSegment& edge, const NearSegment& vertex) {
  return 0x1p-49 * (std::abs(edge.x) + std::abs(edge.y) + std::abs(edge.dx) + std::abs(edge.dy) +
                    std::abs(vertex.x) + std::abs(vertex.y)) +
         0x1p-400;
}

template <typename Numbers>
ApproximatePoint near_place(const ReducedSegment<Numbers>& segment, const Fraction<Numbers>& t) {
  const double near_t = t.near();
  return {segment.near.x + near_t * segment.near.dx, segment.near.y + near_t * segment.near.dy,
          segment.error};
}

/// A place on a segment along an axis, moved to its right by less than there is between integers: so it
/// leaves those boxes around integers that it only touches.
template <typename Numbers>
ApproximatePoint shifted_to_the_right(const ReducedSegment<Numbers>& segment,
                                      ApproximatePoint place) {
  constexpr double part = 0.25;
  if (segment.near.dx == 0) place.x += segment.near.dy > 0 ? part : -part;
  if (segment.near.dy == 0) place.y += segment.near.dx > 0 ? -part : part;
  return place;
}

/// The source of an edge, off by at most a rounding.
inline ApproximatePoint near_source(const NearSegment& edge) {
  return {edge.x, edge.y, 0x1p-50 * (std::abs(edge.x) + std::abs(edge.y)) + 0x1p-400};
}

/// A place less the source of an edge.
inline ApproximatePoint difference(const ApproximatePoint& place, const NearSegment& edge) {
  const ApproximatePoint source = near_source(edge);
  return {place.x - source.x, place.y - source.y,
          place.error + source.error + 0x1p-50 * (std::abs(place.x) + std::abs(place.y))};
}

}  // namespace oplus::slide
