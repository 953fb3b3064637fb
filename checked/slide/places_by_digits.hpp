// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "checked/slide/fraction.hpp"
#include "checked/slide/integer_summands.hpp"
#include "checked/slide/leading_edge.hpp"

namespace oplus::slide {

/// One or two places on a segment by leading digits, each seen from its nearer end, so that what is left of the segment's
/// length there is precise. Where no number may be out of the range of doubles, nothing is certain.
template <typename Numbers>
class PlacesByDigits {
 public:
  explicit PlacesByDigits(const IntegerSummands<Numbers>& summands) : summands_(summands) {}

  bool are_needed() const {
    if constexpr (has_fixed_width<Numbers>) return false;
    return !summands_.p.leading.empty();
  }

  /// One place where both are the same object.
  void look_at(const ReducedSegment<Numbers>& segment, const Fraction<Numbers>& from,
               const Fraction<Numbers>& to) {
    if constexpr (!has_fixed_width<Numbers>) {
      if (!are_needed()) return;
      edge_of_p_ = segment.edge_is_of_p();
      source_ = segment.contact[1];
      const NearVector direction = NearVector::of(segment.exact.direction);
      is_one_ = &from == &to;
      for (std::size_t i = 0; i < (is_one_ ? 1 : 2); ++i) {
        const Fraction<Numbers>& t = i == 0 ? from : to;
        at_target_[i] = t.near() > 0.5;
        const NearNumber part =
            near_number(at_target_[i] ? t.numerator() - t.denominator() : t.numerator()) /
            near_number(t.denominator());
        along_[i] = LeadingVector::of(part * direction);
      }
    }
  }

  /// Whether neither they nor places between them are in the sum of a pair of edges, for certain.
  bool are_outside(const EdgePair& pair) const {
    const auto place = [&](std::size_t i) {
      return LeadingPlace{from_ends(Summand::P, pair.first, i),
                          from_ends(Summand::Q, pair.second, i), along_[i]};
    };
    return are_needed() && ask(place, [&](const auto& places) {
             return certainly_beyond_a_side(places, direction(Summand::P, pair.first),
                                            direction(Summand::Q, pair.second));
           });
  }

  /// The same for a node of the tree of P and one of Q, of which one is a leaf.
  bool are_outside(std::uint32_t of_p, std::uint32_t of_q) const {
    if (!are_needed()) return false;
    const FloatBoxTree::Node &p = summands_.tree_of_p[of_p], &q = summands_.tree_of_q[of_q];
    if (p.is_leaf() == q.is_leaf()) return false;
    return p.is_leaf() ? are_outside(Summand::P, p.edge, summands_.leading_boxes_of_q[of_q])
                       : are_outside(Summand::Q, q.edge, summands_.leading_boxes_of_p[of_p]);
  }

 private:
  bool are_outside(Summand of_edge, std::uint32_t edge, const LeadingBox& box) const {
    const auto place = [&](std::size_t i) {
      const Summand of_box = of_edge == Summand::P ? Summand::Q : Summand::P;
      const LeadingEdge& end = summand(of_box).leading[edge_at_end(of_box)];
      return LeadingPlaceByBox{is_target(of_box, i) ? end.target : end.source,
                               from_ends(of_edge, edge, i), along_[i]};
    };
    return ask(place, [&](const auto& places) {
      return certainly_beyond_a_side(places, box, direction(of_edge, edge));
    });
  }

  template <typename Place, typename Question>
  bool ask(const Place& place, const Question& question) const {
    return is_one_ ? question(std::array{place(0)}) : question(std::array{place(0), place(1)});
  }

  const IntegerSummand<Numbers>& summand(Summand which) const {
    return which == Summand::P ? summands_.p : summands_.q;
  }
  /// The edge that leaves, or where it is the target enters, the vertex at the end from which a place is seen.
  std::uint32_t edge_at_end(Summand which) const {
    return which == Summand::P ? source_.first : source_.second;
  }
  bool is_edge_of(Summand which) const { return edge_of_p_ == (which == Summand::P); }
  bool is_target(Summand which, std::size_t place) const {
    return at_target_[place] && is_edge_of(which);
  }

  LeadingDirection direction(Summand which, std::uint32_t edge) const {
    return {summand(which).leading[edge].direction,
            is_edge_of(which) && edge_at_end(which) == edge};
  }

  /// The end from which a place is seen less the source, and the target, of an edge.
  std::array<LeadingVector, 2> from_ends(Summand which, std::uint32_t edge,
                                         std::size_t place) const {
    const auto& leading = summand(which).leading;
    const auto& previous = summand(which).previous;
    const std::uint32_t own = edge_at_end(which);
    const bool target = is_target(which, place);
    const NearVector& v = target ? leading[own].target : leading[own].source;
    return {LeadingVector::difference(v, leading[edge].source,
                                      target ? previous[edge] == own : edge == own),
            LeadingVector::difference(v, leading[edge].target,
                                      target ? edge == own : previous[own] == edge)};
  }

  const IntegerSummands<Numbers>& summands_;
  bool edge_of_p_ = false;         ///< whether the segment's edge is of P
  EdgePair source_;                ///< of the segment, as the vertices of which it is the sum
  bool is_one_ = false;            ///< whether there is one place, else two
  std::array<bool, 2> at_target_;  ///< whether a place is seen from the segment's other end
  std::array<LeadingVector, 2> along_;
};

}  // namespace oplus::slide
