// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/laws/convex_hull.hpp"
#include "properties/statements/places/overlay.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Pairs of regions, the smaller one first: P and its convex hull; the first component and P; that
/// component and the same without holes.
std::vector<std::pair<Region, Region>> nested(const Region& p) {
  const Region component{{p.components[0]}};
  const Region without_holes = polygon(p.components[0].outer);
  std::vector<std::pair<Region, Region>> pairs = {{p, polygon(convex_hull(chains(p)))}};
  if (component != p) pairs.emplace_back(component, p);
  if (without_holes != component) pairs.emplace_back(component, without_holes);
  return pairs;
}

Outcome broken(const Sum& sum, const Region& smaller, const Region& larger, const Region& q) {
  for (const OverlaidPoint& x : overlaid({sum(smaller, q), sum(larger, q)})) {
    if (x.is_in(0, sum.is_open()) && !x.is_in(1, sum.is_open()))
      return Outcome().fail(to_string(x.point) + " is in the sum of the smaller region only",
                            x.point);
  }
  return {};
}

Outcome law(const Sum& sum, const Summands& summands) {
  const std::vector<std::pair<Region, Region>> pairs = nested(summands.p);
  Outcome outcome;
  for (const auto& [smaller, larger] : pairs) {
    outcome = broken(sum, smaller, larger, summands.q);
    if (outcome.kind == Outcome::Kind::fails) break;
  }
  outcome.counts["nested regions"] += pairs.size();
  return outcome;
}

const Registered registered({
    .id = "law-monotone",
    .sources =
        {{"holes", 4, 3}, {"components", 4, 3}, {"grid", 6, 2}, {"islands", 1, 1}, {"tight", 3, 1}},
    .promises = {{"holes", 15}, {"several components", 15}, {"parallel edges", 40}},
    .kills = {"candidates-need-no-hole-test"},
    .cases = 60,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
