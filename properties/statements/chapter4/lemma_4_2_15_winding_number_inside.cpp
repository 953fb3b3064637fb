// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/points_in_faces.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Point point_at(const VertexIndex& v, const Region& region) {
  return chains(region)[v.chain][v.vertex];
}

Outcome check(const Summands& summands) {
  const auto& [p, q] = summands;
  const std::vector<Segment> before = segments(convolution(p, q));
  const std::vector<Point> points = generic_placements(summands);
  std::vector<int> winding;
  for (const Point& x : points) winding.push_back(winding_number(x, before));
  Outcome outcome;
  outcome.counts["points"] = points.size();
  for (const ReflexVertex& vertex : reflex_vertices(p, q)) {
    const bool of_p = vertex.of == Summand::P;
    const std::vector<Segment> after = segments(replaced_at(vertex, p, q));
    const Region swept = translated(of_p ? q : p, point_at(vertex.vertex, of_p ? p : q));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool inside = locate(points[i], swept) == Location::inside;
      const int now = winding_number(points[i], after);
      ++outcome.counts[inside ? "comparisons inside" : "comparisons outside"];
      if (now == winding[i] - (inside ? 1 : 0)) continue;
      return outcome.fail("the replacement at " + to_string(point_at(vertex.vertex, of_p ? p : q)) +
                              " of " + (of_p ? "P" : "Q") + " changes the winding number at " +
                              to_string(points[i]) + (inside ? ", inside," : ", outside,") +
                              " from " + std::to_string(winding[i]) + " to " + std::to_string(now),
                          points[i]);
    }
  }
  return outcome;
}

const Registered registered(small_mixture(),
                            {.id = "lemma-4.2.15",
                             .kills = {"flip-set-keeps-its-direction", "ray-counts-both-ends"},
                             .cases = 500,
                             .check = check});

}  // namespace

}  // namespace oplus
