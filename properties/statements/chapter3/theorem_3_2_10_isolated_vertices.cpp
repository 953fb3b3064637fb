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

std::size_t directions_through(const Point& x, const std::vector<ConvolutionSegment>& segments) {
  std::vector<Vector> directions;
  for (const ConvolutionSegment& s : segments) {
    const Vector d = direction_of(s.segment);
    if (lies_on(x, s.segment) &&
        std::none_of(directions.begin(), directions.end(),
                     [&](const Vector& known) { return same_direction(known, d); }))
      directions.push_back(d);
  }
  return directions.size();
}

Outcome where_three_meet(const std::vector<Point>& isolated, const Summands& summands) {
  Outcome outcome;
  const std::vector<ConvolutionSegment> reduced = reduced_convolution(summands.p, summands.q);
  const std::set<Point> excepted = sums_of_touching_points(summands);
  for (const Point& x : isolated) {
    ++outcome.counts["isolated vertices"];
    if (excepted.contains(x)) {
      ++outcome.counts["isolated vertices where chains of both summands touch"];
      continue;
    }
    if (directions_through(x, reduced) >= 3) continue;
    return outcome.fail("fewer than three directions meet in the isolated vertex " + to_string(x),
                        x);
  }
  return outcome;
}

Outcome law(const Sum& sum, const Summands& summands) {
  return where_three_meet(sum(summands.p, summands.q).isolated_vertices, summands);
}

Outcome check(const Summands& summands) {
  const std::vector<Point> isolated =
      oracle_sum(summands.p, summands.q, Boundary::open).isolated_vertices;
  Outcome outcome = where_three_meet(isolated, summands);
  if (outcome.kind != Outcome::Kind::holds) return outcome;
  const std::vector<Point> found =
      rca(summands.p, summands.q, Boundary::open).sum.isolated_vertices;
  std::vector<Point> different;
  std::ranges::set_symmetric_difference(isolated, found, std::back_inserter(different));
  if (!different.empty())
    outcome.fail(
        "the filter and the oracle differ on the isolated vertex " + to_string(different.front()),
        different.front());
  return outcome;
}

const Registered registered({
    .id = "theorem-3.2.10",
    .sources =
        {{"tight", 4, 6}, {"grid", 8, 3}, {"holes", 4, 1}, {"components", 3, 1}, {"islands", 1, 1}},
    .promises = {{"reflex vertices", 10}, {"parallel edges", 40}, {"overlapping segments", 5}},
    .kills = {"three-directions-are-too-few"},
    .cases = 100,
    .check = check,
    .of_engine = for_one_engine(law),
});

}  // namespace

}  // namespace oplus
