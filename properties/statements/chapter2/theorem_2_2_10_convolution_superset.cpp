// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/each_engine.hpp"
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter2/boundary_coverage.hpp"
#include "properties/statements/places/covered_sum.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  OpenSum open_sum(summands);
  const Coverage c = coverage(summands, convolution(summands.p, summands.q), open_sum, {});
  Outcome outcome;
  outcome.counts = {{"pieces of the vertex-edge sum", c.pieces},
                    {"pieces off the convolution", c.pieces_left_out},
                    {"points off the convolution", c.points_left_out}};
  if (c.bare_boundary) {
    outcome.fail("the boundary point " + to_string(*c.bare_boundary) +
                     " is on no segment of the convolution of the same direction",
                 *c.bare_boundary);
  }
  return outcome;
}

Outcome law(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  return unless_broken(bare(sum(p, q), convolution(p, q), {}));
}

const Registered registered({
    .id = "theorem-2.2.10",
    .title = "The convolution contains the boundary of the sum",
    .statement =
        "Every point on the boundary of the sum of the open regions, dangling edges and isolated "
        "vertices included (and so the boundary of the closed sum), is on a segment of the "
        "convolution. Where the point is inside a segment of the vertex-edge sum, a segment of "
        "the convolution of the same direction covers it.",
    .why =
        "A segment of the vertex-edge sum is an edge e translated by a vertex v. If the direction "
        "of e is not in v's tangent set, an edge at v points to the right of e; e, translated "
        "along that edge, sweeps over the segment, whose inside is then in the open sum. Where an "
        "edge at v is parallel to e, the segments that the tie rule keeps cover the sum of the "
        "two collinear edges. The contrapositive is tested, by collision tests only: each point "
        "of the vertex-edge sum that is not on the convolution is in the open sum.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed"},
    .rests_on = {"theorem-2.2.6", "lemma-2.2.9"},
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"parallel-edges-do-not-collide", "tangent-set-without-ties"},
    .cases = 400,
    .check = check,
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
