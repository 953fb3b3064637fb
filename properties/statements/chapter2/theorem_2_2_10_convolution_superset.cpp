// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter2/boundary_coverage.hpp"
#include "properties/statements/placements/covered_sum.hpp"
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

const Registered registered(small_mixture(),
                            {.id = "theorem-2.2.10",
                             .kills = {"parallel-edges-do-not-collide", "tangent-set-without-ties"},
                             .cases = 200,
                             .check = check,
                             .of_engine = for_one_engine(law)});

}  // namespace

}  // namespace oplus
