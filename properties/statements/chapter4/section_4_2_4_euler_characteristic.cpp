// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/euler_characteristic.hpp"
#include "properties/statements/chapter4/generic_placements.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

void check_pair(const Summands& summands, Outcome& outcome) {
  const std::vector<Segment> original = segments(original_convolution(summands.p, summands.q));
  const IntersectionCounter counter(summands);
  for (const Point& x : generic_placements(summands)) {
    const CountedIntersection counted = counter.at(x);
    const int winding = winding_number(x, original);
    count(counted, outcome);
    if (winding != static_cast<int>(counted.of_interiors.components))
      ++outcome.counts["placements at which the printed count is wrong"];
    if (winding == counted.euler_characteristic()) continue;
    outcome.fail("at " + to_string(x) + " the winding number is " + std::to_string(winding) +
                 " and the intersection has " + in_words(counted));
    return;
  }
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  for (const Summands& pair : with_covered_holes(summands)) {
    check_pair(pair, outcome);
    if (outcome.kind == Outcome::Kind::fails) break;
  }
  return outcome;
}

const Registered registered({
    .id = "section-4.2.4",
    .kind = "section",
    .title = "With holes the winding number with flip sets is an Euler characteristic",
    .statement =
        "For regions with holes and several components, the winding number of x with respect to 𝒞′ "
        "is the Euler characteristic of the intersection of P and -Q+x: its components less its "
        "holes. A hole that touches the outside in a point, where chains of one summand touch "
        "inside the other, counts as a hole. The section says that winding number and number of "
        "components remain equal, each adding up over pairs of chains; they do not, and the number "
        "of components does not add up (docs/findings.md).",
    .why =
        "Both are the total turning of the intersection's boundary, in full turns: its outer chains "
        "turn once, its holes once backwards. As x moves, each passing of a vertex and an edge "
        "changes the turning as for simple polygons, whatever the rest of the regions. Touching "
        "chains turn as they would just apart.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed",
                   "x is on no segment of the vertex-edge sum"},
    .rests_on = {"lemma-4.2.13", "theorem-4.2.14"},
    .sources = pairs_with_holes(),
    .promises = promises_of_mixture(),
    .kills = {"flip-set-keeps-its-direction", "reflex-vertices-of-q-are-not-replaced",
              "holes-of-an-intersection-are-not-seen", "reflex-turns-clockwise"},
    .cases = 150,
    .check = check,
});

}  // namespace

}  // namespace oplus
