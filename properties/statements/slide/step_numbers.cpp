// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/rca.hpp"
#include "checked/slide/slide.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/validity.hpp"

namespace oplus {

namespace {

/// Large coordinates that are not small numbers times a power of two.
Point stretched(const Point& x, const mpz_class& large) {
  static const Rational shift(mpz_class(1) << 100);
  return {large * x.x + 3 * x.y + shift, 5 * x.x + large * x.y};
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  std::vector<Summands> enlarged;
  // For integers of 128 bits, and for those of GMP.
  for (const int bits : {48, 60}) {
    const mpz_class large = mpz_class(1) << bits;
    const auto stretch = [&](const Point& x) { return stretched(x, large); };
    // Slightly bent, too: what was parallel, collinear or in one point is so only approximately, within the
    // rounding errors of doubles.
    const auto bend = [&](const Point& x) { return stretch(x) + Point{x.y * x.y, x.x * x.y}; };
    enlarged.push_back({mapped(summands.p, stretch), mapped(summands.q, stretch)});
    Summands bent = {mapped(summands.p, bend), mapped(summands.q, bend)};
    if (find_defect(bent.p) || find_defect(bent.q)) continue;
    ++outcome.counts["bent pairs"];
    enlarged.push_back(std::move(bent));
  }
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    EngineOptions options{.with_origins = true};
    const ComputedSum small = slide_sum(summands.p, summands.q, boundary, options);
    std::vector<PlanarSet> expected;
    for (const Summands& pair : enlarged) expected.push_back(rca(pair.p, pair.q, boundary).sum);
    outcome.counts["in 64-bit integers"] += small.statistics.count("in integers of 64 bits") > 0;
    for (const SlideNumbers numbers :
         {SlideNumbers::at_least_128_bits, SlideNumbers::gmp, SlideNumbers::rationals}) {
      options.numbers = numbers;
      const ComputedSum other = slide_sum(summands.p, summands.q, boundary, options);
      if (other.sum != small.sum || other.origins != small.origins)
        return outcome.fail("larger numbers give another sum of the same pair");
      for (std::size_t k = 0; k < enlarged.size(); ++k) {
        const ComputedSum of_large = slide_sum(enlarged[k].p, enlarged[k].q, boundary, options);
        outcome.counts["in 128-bit integers"] +=
            of_large.statistics.count("in integers of 128 bits") > 0;
        if (of_large.statistics.count("in integers of 64 bits") > 0)
          return outcome.fail("coordinates of more than 32 bits are computed in 64 bits");
        if (of_large.sum != expected[k])
          return outcome.fail("slide and rca give different sums of the enlarged pair");
      }
    }
  }
  return outcome;
}

const Registered registered(small_mixture(), {.id = "step-numbers",
                                              .kills = {"slide-believes-doubles"},
                                              .cases = 300,
                                              .check = check});

}  // namespace

}  // namespace oplus
