// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/image.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/places/overlay.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// P + x, where x is a point of the closed Q, must be in the closed sum.
Outcome contains_translates(const Sum& sum, const Region& p, const Region& q) {
  const MinkowskiSum whole = sum(p, q);
  for (const Chain& chain : chains(q)) {
    const MinkowskiSum part = canonical_sum(translated(p, chain[0]));
    for (const OverlaidPoint& at : overlaid({whole, part})) {
      if (at.is_in(1, false) && !at.is_in(0, false))
        return Outcome().fail("P + " + to_string(chain[0]) + " contains " + to_string(at.point) +
                                  ", the sum does not",
                              at.point);
    }
  }
  return {};
}

/// The value at zero of the quadratic through (1, f1), (2, f2), (3, f3); empty if (4, f4) is not on
/// it.
std::optional<Rational> value_at_zero(const Rational& f1, const Rational& f2, const Rational& f3,
                                      const Rational& f4) {
  if (f4 - 3 * f3 + 3 * f2 - f1 != 0) return std::nullopt;
  return Rational(3 * f1 - 3 * f2 + f3);
}

std::string shrinks_to_p(const Sum& sum, const Region& p, const Region& q) {
  const Rational tiny = 1 / Rational(mpz_class(1) << 300);
  const auto area_with = [&](int times) {
    return area(sum(p, image(scaling(Rational(times * tiny)), q)));
  };
  const std::optional<Rational> limit =
      value_at_zero(area_with(1), area_with(2), area_with(3), area_with(4));
  if (!limit) return "the area of P ⊕ λQ is not a quadratic function of λ for small λ";
  if (*limit != area(p))
    return "the area of P ⊕ λQ tends to " + limit->get_str() + ", P's is " + area(p).get_str();
  return "";
}

Outcome law(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  if (!sum.is_open()) {
    const Outcome outcome = contains_translates(sum, p, q);
    if (outcome.kind == Outcome::Kind::fails) return outcome;
  }
  return unless_broken(shrinks_to_p(sum, p, q));
}

const Registered registered({
    .id = "law-point",
    .sources = {{"grid", 6, 4}, {"holes", 4, 2}, {"components", 4, 2}, {"tight", 2, 1}},
    .promises = {{"holes", 15}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"area-is-of-the-first-chain"},
    .cases = 60,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
