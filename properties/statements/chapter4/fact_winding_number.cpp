// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/euler_characteristic.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

/// How many reflex vertices of P are inside -Q+x, and of -Q+x inside P.
int reflex_vertices_inside(const Point& x, const Summands& summands,
                           const std::vector<ReflexVertex>& reflex) {
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  int inside = 0;
  for (const auto& [of, vertex] : reflex) {
    const Point& v = (of == Summand::P ? of_p : of_q)[vertex.chain][vertex.vertex];
    if (locate(x - v, of == Summand::P ? summands.q : summands.p) == Location::inside) ++inside;
  }
  return inside;
}

Outcome check(const Summands& summands) {
  return at_generic_placements(summands, [](const Summands& pair) -> AtPlacement {
    return [pair, all = segments(convolution(pair.p, pair.q)),
            reflex = reflex_vertices(pair.p, pair.q)](
               const Point& x, const CountedIntersection& counted, Outcome& outcome) {
      const int inside = reflex_vertices_inside(x, pair, reflex);
      const int winding = winding_number(x, all);
      if (inside > 0) ++outcome.counts["placements with a reflex vertex inside"];
      if (winding == counted.euler_characteristic() + inside) return std::string();
      return "the winding number is " + std::to_string(winding) + ", " + std::to_string(inside) +
             " reflex vertices are inside, and the intersection has " + in_words(counted);
    };
  });
}

const Registered registered({
    .id = "fact-winding-number",
    .title = "What the winding number of the convolution counts",
    .statement =
        "The winding number of x with respect to the convolution is the Euler characteristic of "
        "the intersection of P and -Q+x, for simple polygons the number of its components, plus "
        "the number of reflex vertices of P inside -Q+x, plus that of -Q+x inside P. Chains that "
        "touch count as in Section 4.2.4.",
    .why =
        "From 𝒞 to 𝒞′, each reflex vertex that is inside the other summand lowers the winding "
        "number by one (Lemma 4.2.15), and the winding number of 𝒞′ is the Euler characteristic "
        "(Section 4.2.4). Each hole of the intersection has at least three reflex corners, each "
        "of them such a vertex, so the winding number is positive wherever there is a component: "
        "Theorem 4.2.1.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed",
                   "x is on no segment of the vertex-edge sum"},
    .rests_on = {"lemma-4.2.15", "section-4.2.4"},
    .sources = pairs_with_holes(),
    .promises = promises_of_mixture(),
    .kills = {"holes-of-an-intersection-are-not-seen", "reflex-turns-clockwise",
              "acute-vertex-is-reflex", "tangent-set-without-ties"},
    .cases = 150,
    .check = check,
});

}  // namespace

}  // namespace oplus
