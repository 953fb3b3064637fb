// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "checked/slide/blocking_search.hpp"
#include "checked/slide/component_test.hpp"
#include "checked/slide/convex_cover.hpp"
#include "checked/slide/place_inside.hpp"

namespace oplus::slide {

/// What FreePieces tells about the rest of a segment, ignored.
struct IgnoreRest {
  template <typename Pair, typename Interval>
  void blocked(const Pair&, const Interval&) {}
  void all_is_inside() {}
  template <typename Interval>
  void inside(const Interval&) {}
  template <typename Piece>
  void overlapping(const Piece&) {}
};

/// Finds what no pair of edges blocks of segments. One object a thread.
///
/// The words of slide: a place on a segment is a point x(t) of it, from its source, t = 0, to its target, t = 1.
/// An edge of P and one of -Q + x(t) block the place if they cross properly, where x(t) is shifted by an
/// infinitesimal to the right of the segment: which they do in one open interval of t (blocked_interval.hpp). A
/// piece is a closed interval of t; it is free if no pair blocks a place inside it and no component is inside
/// another one there. So free pieces are on the boundary of the sum.
template <typename Numbers>
class FreePieces {
 public:
  explicit FreePieces(const IntegerSummands<Numbers>& summands)
      : search_(summands, Shift::to_the_right), cover_(summands), components_(summands) {}

  /// Calls `add` with the maximal free pieces longer than a point; rest.blocked() with intervals that
  /// cover all but these and the pairs that block them, or with inside() and all_is_inside() those that
  /// are in the open sum; and rest.overlapping() with closed pieces on which components overlap.
  template <typename Add, typename Rest = IgnoreRest>
  void find(const ReducedSegment<Numbers>& segment, const Add& add, Rest&& rest = {}) {
    gaps_.assign(1, Piece<Numbers>{{0, 1}, {1, 1}});
    if (search_.compares_all_pairs() || (last_was_free_ && trust_ >= enough_trust)) {
      search_.leave_out_all();
      remember(uncovered(segment, gaps_.back(), add, rest));
      return;
    }
    const auto is_covered = [&] {
      if (!cover_.contains(segment)) return false;
      ++search_.effort.covered;
      remember(false);
      rest.all_is_inside();
      return true;
    };
    // A segment that one pair blocks needs no cover, but a cover that is found at once needs no probe.
    const bool was_asked = cover_.contained_the_last();
    if (was_asked && is_covered()) return;
    bool is_whole = true, was_free = false;
    while (!gaps_.empty()) {
      const Piece<Numbers> gap = std::move(gaps_.back());
      gaps_.pop_back();
      const Fraction<Numbers> t = place_inside(gap);
      if (auto blocked = search_.at(segment, t)) {
        if (is_whole && !was_asked && !blocked->contains_segment() && is_covered()) return;
        rest.blocked(search_.last_pair(), *blocked);
        if (!is_whole) {
          if (const auto inside = cover_.interval_at(segment, t)) {
            rest.inside(*inside);
            if (inside->from < blocked->from) blocked->from = inside->from;
            if (blocked->to < inside->to) blocked->to = inside->to;
          }
        }
        is_whole = false;
        if (gap.from < blocked->from) gaps_.push_back({gap.from, blocked->from});
        if (blocked->to < gap.to) gaps_.push_back({blocked->to, gap.to});
      } else {
        const bool is_free = uncovered(segment, gap, add, rest);
        was_free = is_whole && is_free;
      }
    }
    remember(was_free);
  }

  const SearchEffort& effort() const { return search_.effort; }

 private:
  /// Returns whether that is all of the gap.
  template <typename Add, typename Rest>
  bool uncovered(const ReducedSegment<Numbers>& segment, const Piece<Numbers>& gap, const Add& add,
                 Rest& rest) {
    intervals_.clear();
    bool is_blocked = false;
    search_.each_pair(segment, gap, [&](const EdgePair& pair) {
      if (is_blocked) return;
      auto blocked = search_.interval_of(segment, pair);
      if (!blocked) return;
      rest.blocked(pair, *blocked);
      is_blocked = !(gap.from < blocked->from) && !(blocked->to < gap.to);
      intervals_.push_back(std::move(*blocked));
    });
    if (is_blocked) return false;
    std::sort(intervals_.begin(), intervals_.end(),
              [](const auto& a, const auto& b) { return a.from < b.from; });
    const auto add_if_free = [&](const Fraction<Numbers>& low, const Fraction<Numbers>& high) {
      if (!(low < high)) return;
      Piece<Numbers> piece{low, high};
      // Along a piece, whether components overlap does not change.
      if (components_.is_needed() && components_.overlap_at(segment, place_inside(piece)))
        return rest.overlapping(piece);
      add(std::move(piece));
    };
    bool is_all = true;
    Fraction<Numbers> from = gap.from;
    for (const BlockedInterval<Numbers>& blocked : intervals_) {
      if (!(blocked.from < gap.to)) break;
      add_if_free(from, blocked.from);
      if (from < blocked.to) {
        from = blocked.to;
        is_all = false;
      }
    }
    add_if_free(from, gap.to);
    return is_all;
  }

  /// After a segment that is free from end to end, the next one is likely to be, unless it often was not.
  void remember(bool is_free) {
    constexpr int most_trust = 3;
    if (last_was_free_) trust_ = std::clamp(trust_ + (is_free ? 1 : -1), 0, most_trust);
    last_was_free_ = is_free;
  }

  BlockingSearch<Numbers> search_;
  ConvexCover<Numbers> cover_;
  ComponentTest<Numbers> components_;
  ShortList<Piece<Numbers>> gaps_;
  ShortList<BlockedInterval<Numbers>> intervals_;
  bool last_was_free_ = false;
  static constexpr int enough_trust = 2;
  int trust_ = 1;  ///< that a segment is free if the last one was
};

}  // namespace oplus::slide
