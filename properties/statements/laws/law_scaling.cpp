// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/image.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

std::vector<Rational> factors() {
  const Rational large(mpz_class(1) << 600);
  return {-1, Rational(2, 3), large, 1 / large};
}

Outcome law(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  const MinkowskiSum here = sum(p, q);
  for (const Rational& factor : factors()) {
    const AffineMap map = scaling(factor);
    const std::string what = told_apart(image(map, here), sum(image(map, p), image(map, q)));
    if (!what.empty()) return unless_broken("scaled by " + factor.get_str() + ", " + what);
  }
  return {};
}

const Registered registered({
    .id = "law-scaling",
    .sources = {{"grid", 7, 4},
                {"tight", 4, 2},
                {"holes", 5, 2},
                {"components", 4, 2},
                {"islands", 1, 1},
                {"fork", 2, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 15}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"coordinates-stay-scaled"},
    .cases = 60,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
