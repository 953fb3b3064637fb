// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/image.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

/// By small integers, by fractions, and by numbers whose squares overflow a double.
std::vector<std::pair<Vector, Vector>> translations() {
  const Rational far(mpz_class(1) << 600);
  return {{{3, -5}, {0, 0}},
          {{Rational(1, 3), 0}, {Rational(-2, 7), Rational(5, 11)}},
          {{far, 1}, {-1, far}}};
}

Outcome law(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  const MinkowskiSum here = sum(p, q);
  for (const auto& [s, t] : translations()) {
    const std::string what =
        told_apart(image(AffineMap{.by = s + t}, here), sum(translated(p, s), translated(q, t)));
    if (!what.empty()) return unless_broken(what);
  }
  return {};
}

const Registered registered({
    .id = "law-translation",
    .sources = {{"grid", 7, 4},
                {"tight", 4, 2},
                {"holes", 5, 2},
                {"components", 4, 2},
                {"islands", 1, 1},
                {"fork", 2, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 15}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"coordinates-stay-scaled"},
    .cases = 80,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
