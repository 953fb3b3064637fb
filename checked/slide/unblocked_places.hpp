// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "checked/slide/contact_interval.hpp"
#include "checked/slide/free_pieces.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// Finds where no edges cross properly as a segment is slid along, x(t) not shifted: candidates for
/// low-dimensional features of the open sum (thesis, Section 3.2.4). One object a thread.
template <typename Numbers>
class UnblockedPlaces {
 public:
  explicit UnblockedPlaces(const IntegerSummands<Numbers>& summands)
      : summands_(summands), search_(summands, Shift::none) {}

  /// Calls add(places) with the places of each maximal closed piece without proper crossings, in
  /// order: its ends, and where inside it the contact of a pair of edges begins or ends. Between two
  /// neighbours no pair's contact changes, so that either all or none of the places there are in the
  /// open sum. A piece may be a point.
  template <typename Add>
  void find(const Track<Numbers>& track, const Add& add) {
    gaps_.assign(1, {{0, 1}, {1, 1}});
    while (!gaps_.empty()) {
      const Piece<Numbers> gap = std::move(gaps_.back());
      gaps_.pop_back();
      const bool is_point = !(gap.from < gap.to);
      if (const auto blocked = search_.at(track, is_point ? gap.from : place_inside(gap))) {
        if (!(blocked->from < gap.from)) gaps_.push_back({gap.from, blocked->from});
        if (!(gap.to < blocked->to)) gaps_.push_back({blocked->to, gap.to});
      } else {
        unblocked(track, gap, add);
      }
    }
  }

 private:
  template <typename Add>
  void unblocked(const Track<Numbers>& track, const Piece<Numbers>& gap, const Add& add) {
    intervals_.clear();
    changes_.clear();
    search_.each_pair(track, gap, [&](const EdgePair& pair) {
      if (auto blocked = search_.interval_of(track, pair))
        intervals_.push_back(std::move(*blocked));
      if (OPLUS_MUTANT(
              "slide-forgets-changes-of-contact",
              "contact of edges does not begin or end inside what no pair of edges blocks"))
        return;
      if (auto contact = contact_interval(track.exact, summands_.p.edges[pair.first],
                                          summands_.q.edges[pair.second])) {
        changes_.push_back(std::move(contact->from));
        changes_.push_back(std::move(contact->to));
      }
    });
    std::sort(intervals_.begin(), intervals_.end(),
              [](const auto& a, const auto& b) { return a.from < b.from; });
    std::sort(changes_.begin(), changes_.end());
    Fraction<Numbers> from = gap.from;
    for (const BlockedInterval<Numbers>& blocked : intervals_) {
      if (gap.to < blocked.from) break;
      if (!(blocked.from < from)) add_piece(from, blocked.from, add);
      if (from < blocked.to) from = blocked.to;
    }
    if (!(gap.to < from)) add_piece(from, gap.to, add);
  }

  template <typename Add>
  void add_piece(const Fraction<Numbers>& from, const Fraction<Numbers>& to, const Add& add) {
    std::vector<Fraction<Numbers>> places = {from};
    for (auto change = std::upper_bound(changes_.begin(), changes_.end(), from);
         change != changes_.end() && *change < to; ++change)
      if (places.back() < *change) places.push_back(*change);
    if (places.back() < to) places.push_back(to);
    add(places);
  }

  const IntegerSummands<Numbers>& summands_;
  BlockingSearch<Numbers> search_;
  std::vector<Piece<Numbers>> gaps_;
  std::vector<BlockedInterval<Numbers>> intervals_;
  std::vector<Fraction<Numbers>> changes_;
};

}  // namespace oplus::slide
