// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/blocked_interval.hpp"
#include "checked/slide/contact_interval.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/slide/slid_pair.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  const auto& p = pair.segments.summands().p.edges;
  const auto& q = pair.segments.summands().q.edges;
  const std::vector<Segment> of_p = edges(summands.p);
  const std::vector<Segment> of_q = edges(reflected(summands.q));
  Outcome outcome;
  // All pairs of edges, on about four segments; which ones depends on the size of P.
  const std::uint32_t step = 1 + static_cast<std::uint32_t>(pair.segments.size() / 4);
  for (std::uint32_t i = static_cast<std::uint32_t>(of_p.size()) % step; i < pair.segments.size();
       i += step) {
    const auto segment = pair.segments[i].exact;
    for (std::size_t a = 0; a < p.size(); ++a) {
      for (std::size_t b = 0; b < q.size(); ++b) {
        const auto blocked =
            slide::blocked_interval(segment, p[a], q[b], slide::Shift::to_the_right);
        const auto contact = slide::contact_interval(segment, p[a], q[b]);
        std::vector<SlidPair::Place> ends;
        if (blocked) ends.insert(ends.end(), {blocked->from, blocked->to});
        if (contact) ends.insert(ends.end(), {contact->from, contact->to});
        for (const SlidPair::Place& t : pair.between(ends)) {
          ++outcome.counts["places"];
          const bool is_blocked = blocked && blocked->from < t && t < blocked->to;
          outcome.counts["places where they cross"] += is_blocked;
          const Point x = pair.shifted(i, t);
          const Segment moved{of_q[b].source + x, of_q[b].target + x};
          if (cross_properly(of_p[a], moved) == is_blocked) continue;
          return outcome.fail("at " + to_string(pair.point(i, t)) + " on segment " +
                                  std::to_string(i) + " edge " + std::to_string(a) +
                                  " of P and edge " + std::to_string(b) + " of Q " +
                                  (is_blocked ? "do not cross, and the interval says that they do"
                                              : "cross, and the interval says that they do not"),
                              pair.point(i, t));
        }
      }
    }
  }
  return outcome;
}

const Registered registered(small_mixture(), {.id = "step-interval",
                                              .kills = {"slide-shifts-to-the-left"},
                                              .cases = 500,
                                              .check = check});

}  // namespace

}  // namespace oplus
