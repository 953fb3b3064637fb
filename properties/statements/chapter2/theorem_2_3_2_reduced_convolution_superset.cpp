// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter2/boundary_coverage.hpp"
#include "properties/statements/placements/covered_sum.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// The theorem as printed, for vertices that no other chain touches: no point inside a segment of a
/// reflex vertex is on the boundary.
Outcome check_reflex_segments(const Summands& summands, OpenSum& open_sum) {
  Outcome outcome;
  const auto touched_vertex = [](const Region& region) {
    return [all = chains(region), touching = touching_points(region)](const VertexIndex& index) {
      return std::binary_search(touching.begin(), touching.end(), all[index.chain][index.vertex]);
    };
  };
  const auto is_touched_of_p = touched_vertex(summands.p);
  const auto is_touched_of_q = touched_vertex(summands.q);
  const std::vector<ConvolutionSegment> all = vertex_edge_sum(summands.p, summands.q);
  const std::vector<std::vector<Segment>> pieces = cut_at_intersections(segments(all));
  const auto look_at = [&](const Point& x) {
    ++outcome.counts["points inside segments of reflex vertices"];
    if (outcome.kind == Outcome::Kind::fails || open_sum.contains(x)) return;
    outcome.fail("the boundary point " + to_string(x) + " is inside a segment of a reflex vertex",
                 x);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].vertex_is_reflex) continue;
    const auto& [edge_of, edge, vertex] = all[i].origin;
    if (edge_of == Summand::Q ? is_touched_of_p(vertex) : is_touched_of_q(vertex)) {
      ++outcome.counts["segments of reflex vertices that another chain touches, left out"];
      continue;
    }
    for (const Segment& piece : pieces[i]) {
      look_at(midpoint(piece.source, piece.target));
      if (piece.target != all[i].segment.target) look_at(piece.target);
    }
  }
  return outcome;
}

Outcome check(const Summands& summands) {
  OpenSum open_sum(summands);
  Outcome outcome = check_reflex_segments(summands, open_sum);
  const std::set<Point> excepted = sums_of_touching_points(summands);
  const Coverage c =
      coverage(summands, reduced_convolution(summands.p, summands.q), open_sum, excepted);
  outcome.counts["sums of touching points of both summands, left out"] = excepted.size();
  outcome.counts["pieces off the reduced convolution"] = c.pieces_left_out;
  outcome.counts["points off the reduced convolution"] = c.points_left_out;
  if (c.bare_boundary && outcome.kind == Outcome::Kind::holds) {
    outcome.fail("the boundary point " + to_string(*c.bare_boundary) +
                     " is on no segment of the reduced convolution of the same direction",
                 *c.bare_boundary);
  }
  return outcome;
}

Outcome law(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  return unless_broken(
      bare(sum(p, q), reduced_convolution(p, q), sums_of_touching_points(summands)));
}

const Registered registered(small_mixture(),
                            {.id = "theorem-2.3.2",
                             .kills = {"acute-vertex-is-reflex", "tangent-set-without-ties"},
                             .cases = 80,
                             .check = check,
                             .of_engine = for_one_engine(law)});

}  // namespace

}  // namespace oplus
