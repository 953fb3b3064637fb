// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter5/collision_outcome.hpp"

namespace oplus {

namespace {

const Registered registered({
    .id = "section-5.1",
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"weak-intersections-never-meet"},
    .cases = 60,
    .check =
        [](const Summands& summands) {
          return collision_outcome(*naive_collision(summands.p, summands.q), summands);
        },
});

}  // namespace

}  // namespace oplus
