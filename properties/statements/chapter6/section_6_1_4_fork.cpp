// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/rca.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

namespace {

/// The fork of n teeth on each arm has 8n + 4 vertices.
std::size_t teeth(const Region& fork) { return (vertex_count(fork) - 4) / 8; }

Outcome law(const Sum& computed, const Summands& summands) {
  // A pair that was shrunk or given by the user may not be of the family.
  if (vertex_count(summands.q) != 6 || vertex_count(summands.p) % 8 != 4)
    return {Outcome::Kind::discarded, {}, {}};
  Outcome outcome;
  const std::size_t n = teeth(summands.p);
  const PlanarSet sum = computed(summands.p, summands.q);
  outcome.counts["holes"] += sum.holes.size();
  if (sum.outer.size() == 1 && sum.holes.size() == n * n) return outcome;
  return outcome.fail(counted(n, "tooth", "teeth") + " per arm, " +
                      counted(sum.outer.size(), "outer chain", "outer chains") + " and " +
                      counted(sum.holes.size(), "hole", "holes"));
}

Outcome check(const Summands& summands) {
  const Engine by_rca{.name = "rca", .compute = rca};
  Outcome both;
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const Outcome outcome = law(Sum(by_rca, boundary), summands);
    if (outcome.kind != Outcome::Kind::holds) return outcome;
    for (const auto& [what, count] : outcome.counts) both.counts[what] += count;
  }
  return both;
}

const Registered registered({
    .id = "section-6.1.4",
    .sources = {{"fork", 6, 1}},
    .promises = {{"reflex vertices", 100}, {"parallel edges", 100}},
    .kills = {"no-candidate-is-a-hole"},
    .cases = 60,
    .check = check,
    .of_engine = for_one_engine(law),
});

}  // namespace

}  // namespace oplus
