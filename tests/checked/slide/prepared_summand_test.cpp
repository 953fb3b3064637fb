// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/prepared_summand.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "checked/joined_thread.hpp"
#include "checked/slide/slide.hpp"
#include "reference/families/family.hpp"
#include "reference/io/boundary_name.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

using slide::power_of_two;
using slide::PreparedSummand;

Region times(const Rational& factor, const Region& region) {
  return mapped(region, [&](const Point& p) { return Point{factor * p.x, factor * p.y}; });
}

/// Sums, origins, and what it took: the same are computed from the same numbers.
void expect_as_unprepared(const PreparedSummand& p, const PreparedSummand& q,
                          SlideNumbers numbers = SlideNumbers::as_needed) {
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const EngineOptions options = {.with_origins = true, .numbers = numbers};
    const ComputedSum expected = slide_sum(p.region(), q.region(), boundary, options);
    const ComputedSum result = sum_of_prepared(p, q, boundary, options);
    EXPECT_EQ(result.sum, expected.sum) << name(boundary);
    EXPECT_EQ(result.origins, expected.origins) << name(boundary);
    EXPECT_EQ(result.statistics, expected.statistics) << name(boundary);
  }
}

/// Numbers and scalings differ from pair to pair, also for one summand, and come in any order; more of them
/// than are kept.
TEST(PreparedSummand, is_kept_for_each_scaling) {
  const Summands pair = generate(*find_family("grid"), 8, 5);
  std::vector<PreparedSummand> all;
  const Rational large = power_of_two(90);
  const std::vector<Rational> factors = {1,
                                         Rational(1, 3),
                                         Rational(1, 1000),
                                         Rational(7, 10),
                                         Rational(1, 11),
                                         Rational(1, 13),
                                         Rational(1, 17),
                                         Rational(1, 19),
                                         Rational(1, 23),
                                         1000000,
                                         power_of_two(40),
                                         large / 3,
                                         power_of_two(300),
                                         1 / (large - 1),
                                         1 / (large + 3)};
  for (const Rational& factor : factors) {
    all.emplace_back(times(factor, pair.p));
    all.emplace_back(times(factor, pair.q));
  }
  all.emplace_back(translated(pair.q, {large, large}));  // only the offset is another one
  for (int round = 0; round < 2; ++round)
    for (const PreparedSummand& p : all)
      for (const PreparedSummand& q : all) expect_as_unprepared(p, q);
  for (const SlideNumbers numbers :
       {SlideNumbers::at_least_128_bits, SlideNumbers::gmp, SlideNumbers::rationals})
    expect_as_unprepared(all[0], all[3], numbers);
}

TEST(PreparedSummand, is_shared_by_threads) {
  const Summands pair = generate(*find_family("star"), 60, 2);
  const PreparedSummand p(pair.p);
  std::vector<PreparedSummand> others;
  for (std::uint64_t seed = 0; seed < 16; ++seed)
    others.emplace_back(generate(*find_family("star"), 20, seed).q);
  std::vector<JoinedThread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (const PreparedSummand& q : others)
        EXPECT_EQ(sum_of_prepared(p, q, Boundary::open).sum,
                  slide_sum(p.region(), q.region(), Boundary::open).sum);
    });
}

}  // namespace
}  // namespace oplus
