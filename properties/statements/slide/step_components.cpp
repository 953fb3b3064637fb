// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/blocking_search.hpp"
#include "checked/slide/component_test.hpp"
#include "checked/slide/contact_interval.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/slide/slid_pair.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  slide::IntegerSummands<SlidPair::Numbers> integers(summands.p, summands.q, pair.scaling);
  integers.prepare_component_test();  // also where there is one component
  const slide::ComponentTest<SlidPair::Numbers> components(integers);
  slide::BlockingSearch<SlidPair::Numbers> search(integers, slide::Shift::to_the_right);
  Outcome outcome;
  const auto fail = [&](std::uint32_t segment, const SlidPair::Place& t, const std::string& what) {
    const Point x = pair.point(segment, t);
    return outcome.fail(
        "at " + to_string(x) + " on segment " + std::to_string(segment) + " " + what, x);
  };
  const std::uint32_t step = 1 + static_cast<std::uint32_t>(pair.segments.size() / 8);
  for (std::uint32_t i = 0; i < pair.segments.size(); i += step) {
    const SlidPair::ReducedSegment segment = pair.segments[i];
    std::vector<SlidPair::Place> ends;
    for (const auto& e : integers.p.edges)
      for (const auto& f : integers.q.edges)
        if (const auto contact = slide::contact_interval(segment.exact, e, f))
          ends.insert(ends.end(), {contact->from, contact->to});
    for (const SlidPair::Place& t : pair.between(ends)) {
      if (search.at(segment, t)) continue;
      const bool overlap = components.overlap_at(segment, t);
      ++outcome.counts["places where no edges cross"];
      outcome.counts["places where components overlap"] += overlap;
      if (pair.interiors_meet_at(pair.shifted(i, t)) != overlap)
        return fail(i, t,
                    overlap ? "components are found to overlap, and do not"
                            : "components overlap, and are found not to");
      if (overlap && !components.is_needed())
        return fail(i, t, "components of connected regions overlap");
    }
  }
  return outcome;
}

const Registered registered({
    .id = "step-components",
    .sources =
        {{"components", 5, 4}, {"islands", 2, 2}, {"holes", 5, 2}, {"grid", 8, 2}, {"tight", 6, 2}},
    .promises = {{"several components", 30}, {"holes", 20}},
    .kills = {"slide-components-never-overlap"},
    .cases = 800,
    .check = check,
});

}  // namespace

}  // namespace oplus
