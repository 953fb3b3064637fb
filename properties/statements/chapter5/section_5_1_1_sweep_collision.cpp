// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/sweep/sweep_collision.hpp"
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter5/collision_outcome.hpp"

namespace oplus {

namespace {

const Registered registered({
    .id = "section-5.1.1",
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"sweep-forgets-overlap-direction", "sweep-ignores-weak-intersections"},
    .cases = 60,
    .check =
        [](const Summands& summands) {
          return collision_outcome(*sweep_collision(summands.p, summands.q), summands);
        },
});

}  // namespace

}  // namespace oplus
