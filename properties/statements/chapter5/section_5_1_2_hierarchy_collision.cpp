// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter5/collision_outcome.hpp"

namespace oplus {

namespace {

const Registered registered({
    .id = "section-5.1.2",
    .title = "Hierarchies of bounding volumes decide collision",
    .statement =
        "Two hierarchies of bounding boxes, built once, with that of -Q translated by x, decide "
        "as the definition does whether the interiors of P and -Q+x meet.",
    .why = "Edges whose boxes are apart do not meet, so every pair that crosses or has contact is "
           "visited; section-5.1 says why these suffice.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed"},
    .rests_on = {"section-5.1"},
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"parallel-edges-do-not-collide", "weak-intersections-never-meet"},
    .cases = 100,
    .check =
        [](const Summands& summands) {
          return collision_outcome(*hierarchy_collision(summands.p, summands.q), summands);
        },
});

}  // namespace

}  // namespace oplus
