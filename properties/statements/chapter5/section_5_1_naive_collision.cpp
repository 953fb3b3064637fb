// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter5/collision_outcome.hpp"

namespace oplus {

namespace {

const Registered registered({
    .id = "section-5.1",
    .title = "Crossings, contacts and containment decide collision",
    .statement = "The interiors of P and -Q+x meet iff an edge of one crosses an edge of the other "
                 "properly, or around a point that both boundaries share a sector is inside both, "
                 "or a chain of one that does not meet the other boundary is inside the other.",
    .why =
        "At a proper crossing the interiors meet. Around any other contact they meet iff one of "
        "the sectors between the edges there is inside both regions. If there is neither, no "
        "chain enters the other interior at a contact; so a chain with a contact stays outside "
        "the other interior, and one without is inside or outside as a whole. If none is inside, "
        "each component of an interior is outside the other region, or both have a common chain "
        "in one direction, which the sectors show.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed",
                   "edges are cut where another chain of their region touches them"},
    .rests_on = {},
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"weak-intersections-never-meet"},
    .cases = 100,
    .check =
        [](const Summands& summands) {
          return collision_outcome(*naive_collision(summands.p, summands.q), summands);
        },
});

}  // namespace

}  // namespace oplus
