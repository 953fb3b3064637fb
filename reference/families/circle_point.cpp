// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/circle_point.hpp"

#include "reference/arithmetic/floor_of.hpp"

namespace oplus {

namespace {

constexpr int resolution = 1 << 20;

/// numerator / denominator, to the nearest integer. Requires: denominator > 0.
mpz_class rounded(const mpz_class& numerator, const mpz_class& denominator) {
  return floor_of(2 * numerator + denominator, 2 * denominator);
}

}  // namespace

Point circle_point(Random& random, const mpz_class& radius) {
  // A point in a disc has a random direction. As a complex number its square has twice the angle,
  // again random, and an integer length: that is the rational parametrization of the circle.
  mpz_class a;
  mpz_class b;
  mpz_class length;
  do {
    a = uniform(random, -resolution, resolution);
    b = uniform(random, -resolution, resolution);
    length = a * a + b * b;
  } while (length == 0 || length > mpz_class(resolution) * resolution);
  return {Rational(rounded(radius * (a * a - b * b), length)),
          Rational(rounded(radius * 2 * a * b, length))};
}

}  // namespace oplus
