// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/slide/slid_pair.hpp"

namespace oplus {

namespace {

/// Adds to `outcome` what the search finds, by boxes or in the table of all pairs.
void compare(const SlidPair& pair, std::size_t most_pairs, Outcome& outcome) {
  slide::IntegerSummands<SlidPair::Numbers> integers(pair.summands.p, pair.summands.q, pair.scaling,
                                                     most_pairs);
  integers.prepare_component_test();
  slide::FreePieces<SlidPair::Numbers> search(integers);
  const slide::ComponentTest<SlidPair::Numbers> components(integers);
  for (std::uint32_t i = 0; i < pair.segments.size(); ++i) {
    const SlidPair::ReducedSegment segment = pair.segments[i];
    std::vector<SlidPair::Piece> found, defined;
    search.find(segment, [&](SlidPair::Piece piece) { found.push_back(std::move(piece)); });
    std::vector<slide::BlockedInterval<SlidPair::Numbers>> intervals;
    for (const auto& e : integers.p.edges)
      for (const auto& f : integers.q.edges)
        if (auto blocked = slide::blocked_interval(segment.exact, e, f, slide::Shift::to_the_right))
          intervals.push_back(*blocked);
    std::vector<SlidPair::Place> ends = {{0, 1}, {1, 1}};
    for (const auto& interval : intervals) ends.insert(ends.end(), {interval.from, interval.to});
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 1; k < ends.size(); ++k) {
      if (!(ends[k - 1] < ends[k]) || ends[k - 1] < SlidPair::Place{0, 1} ||
          SlidPair::Place{1, 1} < ends[k])
        continue;
      const SlidPair::Piece piece{ends[k - 1], ends[k]};
      const SlidPair::Place t = slide::place_inside(piece);
      const bool is_blocked =
          std::any_of(intervals.begin(), intervals.end(),
                      [&](const auto& interval) { return interval.from < t && t < interval.to; });
      if (is_blocked || components.overlap_at(segment, t)) continue;
      defined.push_back(piece);
    }
    std::sort(found.begin(), found.end(),
              [](const SlidPair::Piece& a, const SlidPair::Piece& b) { return a.from < b.from; });
    outcome.counts["segments"] += 1;
    outcome.counts["free pieces"] += found.size();
    const auto same = [](const SlidPair::Piece& a, const SlidPair::Piece& b) {
      return !(a.from < b.from) && !(b.from < a.from) && !(a.to < b.to) && !(b.to < a.to);
    };
    if (std::equal(found.begin(), found.end(), defined.begin(), defined.end(), same)) continue;
    outcome.fail("segment " + std::to_string(i) + " has " + std::to_string(found.size()) +
                 " free pieces by search" +
                 (integers.pairs.is_empty() ? " in boxes, " : " in the table, ") +
                 std::to_string(defined.size()) + " by all pairs");
    return;
  }
  outcome.counts["segments inside a convex summand, moved"] += search.effort().covered;
}

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  Outcome outcome;
  compare(pair, 0, outcome);
  if (outcome.kind == Outcome::Kind::holds) compare(pair, slide::few_pairs, outcome);
  return outcome;
}

const Registered registered(small_mixture(),
                            {.id = "step-search",
                             .kills = {"slide-covers-with-closed-summands",
                                       "slide-leaves-boxes-out", "slide-passes-sides-by"},
                             .cases = 1000,
                             .check = check});

}  // namespace

}  // namespace oplus
