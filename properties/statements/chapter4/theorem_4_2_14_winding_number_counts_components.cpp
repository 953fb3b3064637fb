// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/points_in_faces.hpp"
#include "reference/definitions/intersection_components.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

bool is_simple_polygon(const Region& region) { return chains(region).size() == 1; }

Outcome check(const Summands& summands) {
  const auto& [p, q] = summands;
  if (!is_simple_polygon(p) || !is_simple_polygon(q))
    return {Outcome::Kind::discarded, "not two simple polygons", {}};
  Outcome outcome;
  const std::vector<Segment> original = segments(original_convolution(p, q));
  for (const Point& x : generic_placements(summands)) {
    const ComponentsAndHoles seen = intersection_components(p, q, x);
    const int winding = winding_number(x, original);
    ++outcome.counts[seen.components < 2 ? counted(seen.components, "component", "components")
                                         : "two components or more"];
    if (winding == static_cast<int>(seen.components) && seen.holes == 0) continue;
    return outcome.fail("at " + to_string(x) + " the winding number is " + std::to_string(winding) +
                            " and the intersection has " +
                            counted(seen.components, "component", "components") + " and " +
                            counted(seen.holes, "hole", "holes"),
                        x);
  }
  return outcome;
}

const Registered registered({
    .id = "theorem-4.2.14",
    .sources = {{"grid", 8, 6},
                {"simple", 7, 2},
                {"star", 7, 1},
                {"convex", 7, 1},
                {"comb", 3, 1},
                {"fork", 2, 1}},
    .promises = {{"reflex vertices", 10}, {"parallel edges", 40}, {"overlapping segments", 5}},
    .kills = {"flip-set-keeps-its-direction", "reflex-vertices-of-q-are-not-replaced",
              "reflex-turns-clockwise", "tangent-set-without-ties"},
    .cases = 1000,
    .check = check,
});

}  // namespace

}  // namespace oplus
