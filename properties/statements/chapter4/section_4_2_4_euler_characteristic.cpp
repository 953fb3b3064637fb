// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/euler_characteristic.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  return at_generic_placements(summands, [](const Summands& pair) -> AtPlacement {
    return [original = segments(original_convolution(pair.p, pair.q))](
               const Point& x, const CountedIntersection& counted, Outcome& outcome) {
      const int winding = winding_number(x, original);
      if (winding != static_cast<int>(counted.of_interiors.components))
        ++outcome.counts["placements at which the printed count is wrong"];
      if (winding == counted.euler_characteristic()) return std::string();
      return "the winding number is " + std::to_string(winding) + " and the intersection has " +
             in_words(counted);
    };
  });
}

const Registered registered({
    .id = "section-4.2.4",
    .title = "With holes, the winding number with flip sets is an Euler characteristic",
    .statement =
        "For regions with holes and several components, the winding number of x with respect to "
        "𝒞′ is the Euler characteristic of the intersection of P and -Q+x: the number of its "
        "components minus the number of its holes. A hole that touches the outside in a point, "
        "where chains of one summand touch inside the other, counts as a hole. The section says "
        "that winding number and number of components remain equal, since both add up over pairs "
        "of chains; they do not remain equal, since the number of components does not add up "
        "(docs/findings.md, on Section 4.2.4).",
    .why =
        "Both are the total turning of the intersection's boundary, in full turns: each outer "
        "chain turns once counterclockwise, each hole once clockwise. As x moves, each event in "
        "which a vertex passes an edge changes the total turning as for simple polygons, whatever "
        "the regions are elsewhere. Chains that touch turn as if they were slightly apart.",
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
