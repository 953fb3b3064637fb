// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Outcome law(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  Outcome outcome;
  if (const auto found = difference(sum(p, q), sum(q, p)))
    outcome.fail(found->what + ", at " + to_string(found->witness), found->witness);
  return outcome;
}

const Registered registered({
    .id = "law-commutative",
    .sources = {{"grid", 8, 4},
                {"tight", 6, 3},
                {"holes", 5, 2},
                {"components", 5, 2},
                {"islands", 2, 1},
                {"fork", 3, 1},
                {"diamond-u", 1, 1},
                {"simple", 8, 1}},
    .promises = {{"holes", 15},
                 {"several components", 5},
                 {"reflex vertices", 10},
                 {"parallel edges", 40},
                 {"overlapping segments", 5}},
    .kills = {"candidates-need-no-hole-test", "holes-of-q-are-left-out"},
    .cases = 250,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
