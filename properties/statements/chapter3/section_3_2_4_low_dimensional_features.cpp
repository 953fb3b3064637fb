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

std::string in_words(const Segment& edge) {
  return "dangling edge from " + to_string(edge.source) + " to " + to_string(edge.target);
}
std::string in_words(const Point& vertex) { return "isolated vertex " + to_string(vertex); }

Point point_in(const Segment& edge) { return midpoint(edge.source, edge.target); }
Point point_in(const Point& vertex) { return vertex; }

/// Whether the theorem holds of the features of the open sum, and the filter finds these.
template <typename Feature>
Outcome check_features(std::vector<Feature> PlanarSet::*features,
                       Outcome (*theorem)(const std::vector<Feature>&, const Summands&),
                       const Summands& summands) {
  const auto& [p, q] = summands;
  const std::vector<Feature> defined = oracle_sum(p, q, Boundary::open).*features;
  Outcome outcome = theorem(defined, summands);
  if (outcome.kind != Outcome::Kind::holds) return outcome;
  std::vector<Feature> different;
  std::ranges::set_symmetric_difference(defined, rca(p, q, Boundary::open).sum.*features,
                                        std::back_inserter(different));
  if (different.empty()) return outcome;
  return outcome.fail("the filter and the oracle differ on the " + in_words(different.front()),
                      point_in(different.front()));
}

Outcome covered(const std::vector<Segment>& dangling, const Summands& summands) {
  Outcome outcome;
  outcome.counts["dangling edges"] = dangling.size();
  const std::vector<ConvolutionSegment> reduced = reduced_convolution(summands.p, summands.q);
  for (const Segment& edge : dangling) {
    const Vector d = direction_of(edge);
    if (cover(reduced, d, edge) && cover(reduced, -d, edge)) continue;
    return outcome.fail("no opposite segments cover the " + in_words(edge), point_in(edge));
  }
  return outcome;
}

const Registered theorem_3_2_8({
    .id = "theorem-3.2.8",
    .sources = {{"tight", 4, 6},
                {"grid", 8, 3},
                {"holes", 4, 1},
                {"components", 3, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"reflex vertices", 10}, {"parallel edges", 40}, {"overlapping segments", 5}},
    .kills = {"dangling-edges-run-one-way"},
    .cases = 100,
    .check =
        [](const Summands& summands) {
          return check_features(&PlanarSet::dangling_edges, covered, summands);
        },
    .of_engine = for_one_engine([](const Sum& sum, const Summands& summands) {
      return covered(sum(summands.p, summands.q).dangling_edges, summands);
    }),
});

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
    return outcome.fail("fewer than three directions meet in the " + in_words(x), x);
  }
  return outcome;
}

const Registered theorem_3_2_10({
    .id = "theorem-3.2.10",
    .sources =
        {{"tight", 4, 6}, {"grid", 8, 3}, {"holes", 4, 1}, {"components", 3, 1}, {"islands", 1, 1}},
    .promises = {{"reflex vertices", 10}, {"parallel edges", 40}, {"overlapping segments", 5}},
    .kills = {"three-directions-are-too-few"},
    .cases = 100,
    .check =
        [](const Summands& summands) {
          return check_features(&PlanarSet::isolated_vertices, where_three_meet, summands);
        },
    .of_engine = for_one_engine([](const Sum& sum, const Summands& summands) {
      return where_three_meet(sum(summands.p, summands.q).isolated_vertices, summands);
    }),
});

}  // namespace

}  // namespace oplus
