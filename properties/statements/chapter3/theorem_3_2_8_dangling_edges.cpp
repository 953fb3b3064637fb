// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "checked/arrangement/rca.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/covered_sum.hpp"
#include "reference/io/writing.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Outcome covered(const std::vector<Segment>& dangling, const Summands& summands) {
  Outcome outcome;
  outcome.counts["dangling edges"] = dangling.size();
  const std::vector<ConvolutionSegment> reduced = reduced_convolution(summands.p, summands.q);
  for (const Segment& edge : dangling) {
    const Vector d = direction_of(edge);
    if (cover(reduced, d, edge) && cover(reduced, -d, edge)) continue;
    return outcome.fail("no opposite segments cover the dangling edge from " +
                            to_string(edge.source) + " to " + to_string(edge.target),
                        midpoint(edge.source, edge.target));
  }
  return outcome;
}

Outcome law(const Sum& sum, const Summands& summands) {
  return covered(sum(summands.p, summands.q).dangling_edges, summands);
}

Outcome check(const Summands& summands) {
  const std::vector<Segment> dangling =
      oracle_sum(summands.p, summands.q, Boundary::open).dangling_edges;
  Outcome outcome = covered(dangling, summands);
  if (outcome.kind != Outcome::Kind::holds) return outcome;
  const std::vector<Segment> found = rca(summands.p, summands.q, Boundary::open).sum.dangling_edges;
  std::vector<Segment> different;
  std::ranges::set_symmetric_difference(dangling, found, std::back_inserter(different));
  if (different.empty()) return outcome;
  const auto& [source, target] = different.front();
  return outcome.fail("the filter and the oracle differ on the dangling edge from " +
                          to_string(source) + " to " + to_string(target),
                      midpoint(source, target));
}

const Registered registered({
    .id = "theorem-3.2.8",
    .sources = {{"tight", 4, 6},
                {"grid", 8, 3},
                {"holes", 4, 1},
                {"components", 3, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"reflex vertices", 10}, {"parallel edges", 40}, {"overlapping segments", 5}},
    .kills = {"dangling-edges-run-one-way"},
    .cases = 100,
    .check = check,
    .of_engine = for_one_engine(law),
});

}  // namespace

}  // namespace oplus
