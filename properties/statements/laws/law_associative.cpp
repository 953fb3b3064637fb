// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"

namespace oplus {

namespace {

/// Third summands: a triangle, a reflex polygon and Q again.
std::vector<Region> third_summands(const Summands& summands) {
  return {polygon({{0, 0}, {1, 0}, {0, 2}}),
          polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), summands.q};
}

Outcome law(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  const Region pq = region_of(sum.closed(p, q));
  for (const Region& r : third_summands(summands)) {
    const std::string what = told_apart(sum(pq, r), sum(p, region_of(sum.closed(q, r))));
    if (!what.empty()) return unless_broken(what);
  }
  return {};
}

const Registered registered({
    .id = "law-associative",
    .sources = {{"grid", 5, 4},
                {"tight", 2, 2},
                {"holes", 4, 2},
                {"components", 3, 2},
                {"fork", 1, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 15}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"candidates-need-no-hole-test"},
    .cases = 80,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
