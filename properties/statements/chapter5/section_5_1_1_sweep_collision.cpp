// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/sweep/sweep_collision.hpp"
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter5/collision_outcome.hpp"

namespace oplus {

namespace {

const Registered registered({
    .id = "section-5.1.1",
    .title = "A sweep that stops at the first common interior decides collision",
    .statement =
        "Sweep a line over the boundaries of P and -Q+x, and stop at the first proper crossing, "
        "at the first event around which a sector is inside both, or before the sweep if edges "
        "overlap in the same direction. The interiors of P and -Q+x meet, by the definition, iff "
        "the sweep is stopped or a chain is inside the other region.",
    .why = "The sweep meets every point that both boundaries share, and knows the edges that leave "
           "it in their order around it; section-5.1 says why these points suffice.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed"},
    .rests_on = {"section-5.1"},
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"sweep-forgets-overlap-direction", "sweep-ignores-weak-intersections"},
    .cases = 100,
    .check =
        [](const Summands& summands) {
          return collision_outcome(*sweep_collision(summands.p, summands.q), summands);
        },
});

}  // namespace

}  // namespace oplus
