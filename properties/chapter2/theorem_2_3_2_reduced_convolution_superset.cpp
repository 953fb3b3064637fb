// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/chapter2/boundary_coverage.hpp"
#include "properties/chapter2/cut_at_intersections.hpp"
#include "properties/runner/registry.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// The theorem as printed: no point inside a segment of a reflex vertex is on the boundary.
Outcome check_reflex_segments(const Summands& summands, OpenSum& open_sum) {
  Outcome outcome;
  const std::vector<ConvolutionSegment> all = vertex_edge_sum(summands.p, summands.q);
  const std::vector<std::vector<Segment>> pieces = cut_at_intersections(segments(all));
  const auto look_at = [&](const Point& x) {
    ++outcome.counts["points inside segments of reflex vertices"];
    if (outcome.kind == Outcome::Kind::fails || open_sum.contains(x)) return;
    outcome.kind = Outcome::Kind::fails;
    outcome.why = "the boundary point " + to_string(x) + " is inside a segment of a reflex vertex";
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_reflex(all[i].corner)) continue;
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
  const Coverage c = coverage(summands, reduced_convolution(summands.p, summands.q), open_sum);
  outcome.counts["pieces off the reduced convolution"] = c.pieces_left_out;
  outcome.counts["points off the reduced convolution"] = c.points_left_out;
  if (c.bare_boundary && outcome.kind == Outcome::Kind::holds) {
    outcome.kind = Outcome::Kind::fails;
    outcome.why = "the boundary point " + to_string(*c.bare_boundary) +
                  " is on no equally directed segment of the reduced convolution";
  }
  return outcome;
}

const Registered registered({
    .id = "theorem-2.3.2",
    .kind = "theorem",
    .title = "The reduced convolution contains the boundary of the sum",
    .statement =
        "No point inside a segment made with a reflex vertex is on the boundary of the sum of the "
        "open regions. The reduced convolution therefore covers that boundary, dangling edges and "
        "isolated vertices included, and with equally directed segments, as theorem-2.2.10 says of "
        "the convolution.",
    .why =
        "Around a reflex vertex the interior fills more than a half plane, around a point inside "
        "an "
        "edge it fills a half plane. A half plane and the reflection of anything larger meet, so "
        "the interiors meet at that placement. An isolated vertex at a reflex vertex is touched by "
        "a convex vertex of the other summand, whose segments along both edges are kept.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed"},
    .rests_on = {"theorem-2.2.10"},
    .sources = {{"grid", 8, 5}},
    .promises = {{"reflex_vertices", 20}, {"parallel_edges", 20}, {"overlapping_segments", 10}},
    .kills = {"acute-vertex-is-reflex", "tangent-set-without-ties"},
    .cases = 120,
    .file = __FILE__,
    .check = check,
});

}  // namespace

}  // namespace oplus
