// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/random/uniform_int_distribution.hpp>
#include <cstdint>
#include <utility>

#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"

// Pairs whose coordinates differ much in size, or have no common denominator that is short.

namespace oplus {

namespace {

/// Between 0 and 1/4, with an odd denominator of 32 bits.
Rational small_fraction(Random& random) {
  const auto denominator = boost::random::uniform_int_distribution<std::uint32_t>(
                               std::uint32_t{1} << 31, ~std::uint32_t{0})(random) |
                           1U;
  const auto numerator =
      boost::random::uniform_int_distribution<std::uint32_t>(0, denominator / 4)(random);
  Rational fraction(numerator, denominator);
  fraction.canonicalize();
  return fraction;
}

Region moved_a_little(Random& random, const Region& region) {
  return mapped(region, [&](const Point& p) {
    Rational x = p.x + small_fraction(random);
    return Point{std::move(x), p.y + small_fraction(random)};
  });
}

}  // namespace

Summands outlier_pair(Random& random, std::size_t n) {
  Summands pair = comb_pair(random, n);
  // The tips of the teeth are every second vertex of the zigzag, which ends with the first valley.
  Chain& chain = pair.p.components[0].outer;
  chain[3 + 2 * uniform_index(random, n)].y = 1'000'000'000;
  return pair;
}

Summands scales_pair(Random& random, std::size_t n) {
  Region p = star_polygon(random, n);
  const Rational factor("1000000000000");
  Region q = mapped(star_polygon(random, std::min<std::size_t>(n, 20)),
                    [&](const Point& v) { return factor * v; });
  return {std::move(p), std::move(q)};
}

/// What moves vertices of a comb by less than 1/4 leaves it simple: its zigzag runs from right to left in
/// steps of at least 1, at least 1 above its back.
Summands fractions_pair(Random& random, std::size_t n) {
  Region p = moved_a_little(random, comb_polygon(random, n));
  Region q = moved_a_little(random, polygon({{0, 0}, {uniform(random, 1, 3), 0}, {0, 2}}));
  return {std::move(p), std::move(q)};
}

}  // namespace oplus
