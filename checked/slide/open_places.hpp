// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "checked/slide/contact_interval.hpp"
#include "checked/slide/contacts.hpp"
#include "checked/slide/free_pieces.hpp"
#include "checked/slide/named_ends.hpp"
#include "checked/slide/short_list.hpp"

namespace oplus::slide {

/// Whether a segment leads to the right or straight up.
template <typename Numbers>
bool is_to_the_right(const IntegerVector<Numbers>& direction) {
  return direction.x > 0 || (direction.x == 0 && direction.y > 0);
}

/// Whether each dangling edge and isolated vertex can be found on segments to the right: if the chains
/// of one summand at least do not touch (docs/slide.md). Dangling edges always can.
template <typename Numbers>
bool right_is_enough(const RaysOfBoth<Numbers>& rays) {
  return !rays[0].has_touching_points() || !rays[1].has_touching_points();
}

/// Where something of dimension one or zero may be missing in the open sum (thesis, Section 3.2.4):
/// pieces of segments, and points, which are pieces that end where they begin.
template <typename Numbers>
struct OpenCandidates {
  std::vector<FreePiece<Numbers>> pieces;
  std::vector<FreePiece<Numbers>> points;

  void take(OpenCandidates&& more) {
    for (auto list : {&OpenCandidates::pieces, &OpenCandidates::points})
      (this->*list)
          .insert((this->*list).end(), std::make_move_iterator((more.*list).begin()),
                  std::make_move_iterator((more.*list).end()));
  }
};

/// Finds what pairs of edges do not block of segments, x(t) not shifted, and what is not free. A pair
/// blocks where its edges cross properly, and while the interiors of both summands meet at a vertex
/// that slides along an edge. One object a thread.
template <typename Numbers>
class OpenPlaces {
 public:
  OpenPlaces(const IntegerSummands<Numbers>& summands, const RaysOfBoth<Numbers>& rays)
      : summands_(summands), search_(summands, Shift::none), contacts_(summands, rays) {}

  OpenCandidates<Numbers> found;

  /// Calls `add` with the free pieces of a segment, as `closed` finds them; adds what the pairs that
  /// it looks at do not block.
  template <typename Add>
  void find(FreePieces<Numbers>& closed, std::uint32_t number,
            const ReducedSegment<Numbers>& segment, const Add& add) {
    start(number, segment);
    settled_.clear();
    closed.find(
        segment,
        [&](Piece<Numbers> piece) {
          settled_.push_back(piece);
          add(std::move(piece));
        },
        *this);
    if (covers_all_) return;
    std::sort(settled_.begin(), settled_.end(),
              [](const auto& a, const auto& b) { return a.from < b.from; });
    each_left({{0, 1}, {1, 1}}, [&](const Piece<Numbers>& left) { add_unsettled(left); });
  }

  /// Adds what no pair blocks of a piece.
  void look_into(std::uint32_t number, const ReducedSegment<Numbers>& segment,
                 const Piece<Numbers>& piece) {
    start(number, segment);
    gaps_.assign(1, piece);
    while (!gaps_.empty()) {
      const Piece<Numbers> gap = std::move(gaps_.back());
      gaps_.pop_back();
      if (!(gap.from < gap.to)) {
        add(gap.from, gap.to);
      } else if (const auto blocked = search_.at(segment, place_inside(gap))) {
        if (!(blocked->from < gap.from)) gaps_.push_back({gap.from, blocked->from});
        if (!(gap.to < blocked->to)) gaps_.push_back({blocked->to, gap.to});
      } else {
        intervals_.clear();
        search_.each_pair(segment, gap, [&](const EdgePair& pair) { add_interval(pair, nullptr); });
        each_left(gap, [&](const Piece<Numbers>& left) { add(left.from, left.to); });
      }
    }
  }

  // What FreePieces tells.
  void blocked(const EdgePair& pair, const BlockedInterval<Numbers>& shifted) {
    if (!covers_all_) add_interval(pair, &shifted);
  }
  void all_is_inside() { covers_all_ = true; }
  void inside(const BlockedInterval<Numbers>& interval) {
    // By no pair: that of the segment is as good as any at the ends.
    intervals_.push_back({interval.from, interval.to, segment_->contact[0]});
  }
  void overlapping(const Piece<Numbers>& piece) { settled_.push_back(piece); }

 private:
  void start(std::uint32_t number, const ReducedSegment<Numbers>& segment) {
    segment_ = &segment;
    number_ = number;
    covers_all_ = false;
    intervals_.clear();
  }

  void add(const Fraction<Numbers>& from, const Fraction<Numbers>& to) {
    (from < to ? found.pieces : found.points).push_back({number_, {from, to}});
  }

  struct Interval {
    Fraction<Numbers> from;
    Fraction<Numbers> to;
    EdgePair by;
  };

  /// Adds what a pair blocks. `crossing`: where its edges cross, if it is known and not empty; with
  /// a shift it is the same, but for vertices that slide along edges.
  void add_interval(const EdgePair& pair, const BlockedInterval<Numbers>* crossing) {
    const IntegerSegment<Numbers>& exact = segment_->exact;
    if (const auto contact = contacts_.along(exact, pair)) {
      if (!contacts_.interiors_meet_at(*contact)) return;
      const auto piece =
          contact_interval(exact, summands_.p.edges[pair.first], summands_.q.edges[pair.second]);
      if (!piece || !(piece->from < piece->to)) return;
      places_.clear();
      contacts_.each_touching_point(exact, *contact, [&](const Fraction<Numbers>& t) {
        if (piece->from < t && t < piece->to) places_.push_back(t);
      });
      std::sort(places_.begin(), places_.end());
      Fraction<Numbers> from = piece->from;
      for (const Fraction<Numbers>& to : places_) {
        intervals_.push_back({from, to, pair});
        from = to;
      }
      intervals_.push_back({from, piece->to, pair});
      return;
    }
    if (crossing) {
      intervals_.push_back({crossing->from, crossing->to, pair});
      covers_all_ = crossing->contains_segment();
    } else if (const auto blocked = search_.interval_of(*segment_, pair)) {
      intervals_.push_back({blocked->from, blocked->to, pair});
    }
  }

  /// Calls visit(piece) with the maximal closed pieces that the intervals leave of one, except for
  /// points at which a pair that blocks what is beside them, or the pair of the segment, has a common sector.
  template <typename Visit>
  void each_left(const Piece<Numbers>& of, const Visit& visit) {
    std::sort(intervals_.begin(), intervals_.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
    const auto visit_left = [&](const Fraction<Numbers>& from, const Fraction<Numbers>& to,
                                const Interval* before, const Interval* behind) {
      if (from < to || !((before && meet_at(from, before->by)) ||
                         (behind && meet_at(from, behind->by)) || meet_at_end(from)))
        visit(Piece<Numbers>{from, to});
    };
    Fraction<Numbers> from = of.from;
    const Interval* before = nullptr;
    for (const Interval& blocked : intervals_) {
      if (of.to < blocked.from) break;
      if (!(blocked.from < from)) visit_left(from, blocked.from, before, &blocked);
      if (from < blocked.to) {
        from = blocked.to;
        before = &blocked;
      }
    }
    if (!(of.to < from)) visit_left(from, of.to, before, nullptr);
  }

  bool meet_at(const Fraction<Numbers>& t, const EdgePair& pair) {
    const auto contact = contacts_.at(segment_->exact, t, pair);
    return contact && contacts_.interiors_meet_at(*contact);
  }

  /// At an end of the segment two vertices touch.
  bool meet_at_end(const Fraction<Numbers>& t) {
    if (t.numerator() != 0 && t.numerator() != t.denominator()) return false;
    return meet_at(t, segment_->contact[0]) || meet_at(t, segment_->contact[1]);
  }

  /// What is left of a piece without the settled ones, which are inside such pieces or apart from them.
  void add_unsettled(const Piece<Numbers>& left) {
    Fraction<Numbers> from = left.from;
    bool is_settled = false;
    for (const Piece<Numbers>& settled : settled_) {
      if (settled.to < left.from || left.to < settled.from) continue;
      is_settled = true;
      if (from < settled.from) add(from, settled.from);
      from = settled.to;
    }
    if (from < left.to || !is_settled) add(from, left.to);
  }

  const IntegerSummands<Numbers>& summands_;
  BlockingSearch<Numbers> search_;
  Contacts<Numbers> contacts_;
  const ReducedSegment<Numbers>* segment_ = nullptr;
  std::uint32_t number_ = 0;
  bool covers_all_ = false;
  ShortList<Interval> intervals_;
  ShortList<Piece<Numbers>> settled_;  ///< free, or in the open sum since components overlap
  ShortList<Piece<Numbers>> gaps_;
  ShortList<Fraction<Numbers>> places_;
};

}  // namespace oplus::slide
