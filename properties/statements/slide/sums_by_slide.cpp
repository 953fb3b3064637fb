// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "checked/arrangement/rca.hpp"
#include "checked/slide/slide.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/validity.hpp"

namespace oplus {

namespace {

Outcome check_turning(const Summands& summands) {
  const PlanarSet sum = slide_sum(summands.p, summands.q, Boundary::closed).sum;
  Outcome outcome;
  for (const std::vector<Chain>* of_kind : {&sum.outer, &sum.holes}) {
    for (const Chain& chain : *of_kind) {
      const bool is_outer = of_kind == &sum.outer;
      ++outcome.counts[is_outer ? "outer chains" : "holes"];
      if ((sign(twice_area(chain)) > 0) == is_outer) continue;
      return outcome.fail(
          is_outer ? "an outer chain runs clockwise" : "a hole runs counterclockwise", chain[0]);
    }
  }
  return outcome;
}

const Registered step_turning({
    .id = "step-turning",
    .sources = {{"grid", 8, 2},
                {"tight", 6, 4},
                {"holes", 5, 3},
                {"components", 5, 2},
                {"islands", 2, 1},
                {"fork", 3, 2},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 15}},
    .kills = {"slide-sees-no-right-turn"},
    .cases = 1000,
    .check = check_turning,
});

Outcome check_prepared(const Summands& summands) {
  Outcome outcome;
  // Integers, other denominators, and what takes 128 bits, and GMP.
  const Rational large(mpz_class(1) << 40);
  std::vector<slide::PreparedSummand> of_p, of_q;
  for (const Rational& factor : {Rational(1), Rational(1, 3), Rational(1, 1000), large,
                                 Rational(large * large / 7), Rational(large * large * large)}) {
    const auto times = [&](const Point& x) { return Point{factor * x.x, factor * x.y}; };
    of_p.emplace_back(mapped(summands.p, times));
    of_q.emplace_back(mapped(summands.q, times));
  }
  const EngineOptions options{.with_origins = true};
  for (const Boundary boundary : {Boundary::closed, Boundary::open})
    for (const slide::PreparedSummand& p : of_p)
      for (const slide::PreparedSummand& q : of_q) {
        const ComputedSum prepared = sum_of_prepared(p, q, boundary, options);
        const ComputedSum alone = slide_sum(p.region(), q.region(), boundary, options);
        ++outcome.counts["sums"];
        if (prepared.sum != alone.sum || prepared.origins != alone.origins)
          return outcome.fail("a prepared summand gives another sum");
      }
  return outcome;
}

const Registered step_prepared(small_mixture(), {.id = "step-prepared",
                                                 .kills = {"slide-keeps-any-denominator"},
                                                 .cases = 60,
                                                 .check = check_prepared});

/// Coordinates beyond the range of doubles in x, and not in y.
Point far_reaching(const Point& x) {
  static const mpz_class large = (mpz_class(1) << 1500) / 3;
  return {large * x.x + 3 * x.y, 5 * x.x + x.y};
}

/// Large coordinates that are not small numbers times a power of two.
Point stretched(const Point& x, const mpz_class& large) {
  static const Rational shift(mpz_class(1) << 100);
  return {large * x.x + 3 * x.y + shift, 5 * x.x + large * x.y};
}

Outcome check_numbers(const Summands& summands) {
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
  enlarged.push_back({mapped(summands.p, far_reaching), mapped(summands.q, far_reaching)});
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

const Registered step_numbers(small_mixture(),
                              {.id = "step-numbers",
                               .kills = {"slide-believes-doubles", "slide-believes-leading-digits"},
                               .cases = 300,
                               .check = check_numbers});

}  // namespace

}  // namespace oplus
