// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/rca.hpp"
#include "checked/slide/slide.hpp"
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/validity.hpp"

namespace oplus {

namespace {

/// Large coordinates that are not small numbers times a power of two.
Point stretched(const Point& x) {
  static const mpz_class large = mpz_class(1) << 60;
  static const Rational shift(mpz_class(1) << 100);
  return {large * x.x + 3 * x.y + shift, 5 * x.x + large * x.y};
}

/// Stretched and slightly bent: what was parallel, collinear or in one point is so only
/// approximately, within the rounding errors of doubles.
Point bent(const Point& x) { return stretched(x) + Point{x.y * x.y, x.x * x.y}; }

Outcome check(const Summands& summands) {
  Outcome outcome;
  std::vector<Summands> large = {{mapped(summands.p, stretched), mapped(summands.q, stretched)}};
  Summands bent_pair = {mapped(summands.p, bent), mapped(summands.q, bent)};
  if (!find_defect(bent_pair.p) && !find_defect(bent_pair.q)) large.push_back(std::move(bent_pair));
  outcome.counts["bent pairs"] += large.size() - 1;
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    EngineOptions options{.with_origins = true};
    const ComputedSum small = slide_sum(summands.p, summands.q, boundary, options);
    outcome.counts["in 64-bit integers"] += small.statistics.count("in integers of 64 bits") > 0;
    for (const SlideNumbers numbers :
         {SlideNumbers::at_least_128_bits, SlideNumbers::gmp, SlideNumbers::rationals}) {
      options.numbers = numbers;
      const ComputedSum other = slide_sum(summands.p, summands.q, boundary, options);
      if (other.sum != small.sum || other.origins != small.origins)
        return outcome.fail("larger numbers give another sum of the same pair");
      for (const Summands& pair : large) {
        const ComputedSum of_large = slide_sum(pair.p, pair.q, boundary, options);
        if (of_large.statistics.count("in integers of 64 bits") > 0)
          return outcome.fail("coordinates of more than 64 bits are computed in 64 bits");
        if (of_large.sum != rca(pair.p, pair.q, boundary).sum)
          return outcome.fail("slide and rca give different sums of the enlarged pair");
      }
    }
  }
  return outcome;
}

const Registered registered({
    .id = "step-numbers",
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"slide-believes-doubles"},
    .cases = 300,
    .check = check,
});

}  // namespace

}  // namespace oplus
