// SPDX-License-Identifier: GPL-3.0-or-later
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

const Registered registered(
    pairs_with_holes(),
    {
        .id = "section-4.2.4",
        .kills = {"flip-set-keeps-its-direction", "reflex-vertices-of-q-are-not-replaced",
                  "holes-of-an-intersection-are-not-seen", "reflex-turns-clockwise"},
        .cases = 60,
        .check = check,
    });

}  // namespace

}  // namespace oplus
