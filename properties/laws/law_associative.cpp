// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/laws/each_engine.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

/// Third summands: a triangle, a reflex polygon and Q again.
std::vector<Region> third_summands(const Summands& summands) {
  return {polygon({{0, 0}, {1, 0}, {0, 2}}),
          polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), summands.q};
}

Outcome check(const Summands& summands) {
  const auto& [p, q] = summands;
  return of_each_engine(std::function<std::string(const BothSums&)>([&](const BothSums& sums) {
    const Region pq = region_of(sums.closed(p, q));
    for (const Region& r : third_summands(summands)) {
      const Region qr = region_of(sums.closed(q, r));
      for (const Sum* sum : {&sums.closed, &sums.open}) {
        std::string what = told_apart((*sum)(pq, r), (*sum)(p, qr));
        if (!what.empty()) return (sum == &sums.open ? "open, " : "closed, ") + what;
      }
    }
    return std::string();
  }));
}

const Registered registered({
    .id = "law-associative",
    .kind = "law",
    .title = "Three summands may be bracketed either way",
    .statement = "(P ⊕ Q) ⊕ R = P ⊕ (Q ⊕ R): the outer sums closed or open, the inner ones the "
                 "closed sums, as regions.",
    .why = "Addition of points is associative. The open inner sum may lack dangling edges and "
           "isolated vertices that the region has; that makes no difference to the open outer sum, "
           "since two open sets that have a point in common have it off any segment, too.",
    .hypotheses = {"P and Q are valid regions, R a triangle, an L or Q"},
    .rests_on = {"section-3.2"},
    .sources = {{"grid", 5, 4},
                {"tight", 2, 2},
                {"holes", 4, 2},
                {"components", 3, 2},
                {"fork", 1, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 15}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"candidates-need-no-hole-test"},
    .cases = 80,
    .file = __FILE__,
    .check = check,
});

}  // namespace

}  // namespace oplus
