// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/euler_characteristic.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

Outcome check_euler_characteristic(const Summands& summands) {
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

const Registered section_4_2_4(
    pairs_with_holes(),
    {
        .id = "section-4.2.4",
        .kills = {"flip-set-keeps-its-direction", "reflex-vertices-of-q-are-not-replaced",
                  "holes-of-an-intersection-are-not-seen", "reflex-turns-clockwise"},
        .cases = 60,
        .check = check_euler_characteristic,
    });

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

Outcome check_winding_number(const Summands& summands) {
  return at_generic_placements(summands, [](const Summands& pair) -> AtPlacement {
    return [pair, all = segments(convolution(pair.p, pair.q)),
            reflex = reflex_vertices(pair.p, pair.q)](
               const Point& x, const CountedIntersection& counted, Outcome& outcome) {
      const int inside = reflex_vertices_inside(x, pair, reflex);
      const int winding = winding_number(x, all);
      if (inside > 0) ++outcome.counts["placements with a reflex vertex inside"];
      if (winding == counted.euler_characteristic() + inside) return std::string();
      return "the winding number is " + std::to_string(winding) +
             ", reflex vertices inside: " + std::to_string(inside) + ", and the intersection has " +
             in_words(counted);
    };
  });
}

const Registered fact_winding_number(pairs_with_holes(),
                                     {.id = "fact-winding-number",
                                      .kills = {"holes-of-an-intersection-are-not-seen",
                                                "reflex-turns-clockwise", "acute-vertex-is-reflex",
                                                "tangent-set-without-ties"},
                                      .cases = 150,
                                      .check = check_winding_number});

}  // namespace

}  // namespace oplus
