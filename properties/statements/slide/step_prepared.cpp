// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "checked/slide/slide.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
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

const Registered registered(small_mixture(), {.id = "step-prepared",
                                              .kills = {"slide-keeps-any-denominator"},
                                              .cases = 60,
                                              .check = check});

}  // namespace

}  // namespace oplus
