// SPDX-License-Identifier: MIT
#include "reference/arithmetic/rational_rotation.hpp"

#include <algorithm>

#include "reference/arithmetic/floor_of.hpp"
#include "reference/arithmetic/simplest_between.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

/// Numbers as multiples of a unit 2^-bits. Requires: bits >= 64.
class FixedPoint {
 public:
  explicit FixedPoint(unsigned long bits) : bits_(bits), one_(mpz_class(1) << bits) {}

  /// What all results below differ by at most from the exact numbers, in units.
  mpz_class slack() const { return 10 * mpz_class(bits_); }

  /// The arctangent of x, for |x| < 0.42; off by less than `bits` units. In the series x - x³/3 + x⁵/5 - ...
  /// a power is off by less than 1 + 0.18 + 0.18² + ... < 1.25 units, its quotient by less than 1.5; a power
  /// has at least 2.4 bits less than the one before, so there are at most bits / 2.4 + 3 terms, and those
  /// left out come to less than 3 units.
  mpz_class arctangent(const Rational& x) const {
    const Rational square = x * x;
    mpz_class power = floor_of(x.get_num() * one_, x.get_den());
    mpz_class sum = power;
    for (unsigned long odd = 3; power != 0; odd += 2) {
      power = -floor_of(power * square.get_num(), square.get_den());
      sum += floor_of(power, odd);
    }
    return sum;
  }

  /// π/4 = 4 arctan 1/5 - arctan 1/239 (Machin); off by less than 5 bits units.
  mpz_class quarter_of_pi() const {
    return 4 * arctangent(Rational(1, 5)) - arctangent(Rational(1, 239));
  }

  struct CosineAndSine {
    mpz_class cosine, sine;
  };

  /// Of an angle from 0 to 68 degrees; off by less than 10 bits units. The angle x < 1.2 is off by less
  /// than 5 bits 68/45 + 1 < 8 bits units, and so are both for this reason, their slopes being at most 1. A
  /// term of the series is xⁱ/i! < 1.2, made from the one before; off by less than 2 units, and so are, from
  /// the third on, the terms at least halved, so that there are at most bits + 4, half of them in each
  /// series. Those left out come to less than 3 units.
  CosineAndSine cosine_and_sine(const Rational& degrees) const {
    const mpz_class x = floor_of(Rational(quarter_of_pi() * degrees / 45));
    CosineAndSine sums{one_, 0};
    mpz_class term = one_;
    for (unsigned long i = 1; term != 0; ++i) {
      term = floor_of(term * x, one_ * i);
      mpz_class& sum = i % 2 == 0 ? sums.cosine : sums.sine;
      if (i % 4 < 2)
        sum += term;
      else
        sum -= term;
    }
    return sums;
  }

 private:
  unsigned long bits_;
  mpz_class one_;
};

/// As many bits as leave 64 behind the first one of a number.
unsigned long bits_for(const Rational& error) {
  const mpz_class parts = floor_of(1 / error) + 1;
  return 72 + static_cast<unsigned long>(mpz_sizeinbase(parts.get_mpz_t(), 2));
}

/// By 2 arctan(t): the rational parametrization of the circle.
RationalRotation with_half_tangent(const Rational& t) {
  const Rational square = t * t;
  return {(1 - square) / (1 + square), 2 * t / (1 + square)};
}

/// The rotation nearest to none by at least degrees - error and at most degrees + error, whose t has the
/// smallest denominator. Requires: 0 < degrees - error, degrees + error <= 135.
RationalRotation simplest_half_tangent(const Rational& degrees, const Rational& error) {
  const FixedPoint numbers(bits_for(error));
  const auto tangent = [&](const Rational& angle, const mpz_class& slack) {
    const auto [cosine, sine] = numbers.cosine_and_sine(angle);
    return Rational(mpz_class(sine + slack), mpz_class(cosine - slack));
  };
  const mpz_class slack = numbers.slack();
  Rational low = tangent((degrees - error) / 2, slack);
  Rational high = tangent((degrees + error) / 2, -slack);
  low.canonicalize();
  high.canonicalize();
  return with_half_tangent(simplest_between(low, high));
}

/// Turned on by 90 degrees, so many times.
RationalRotation with_quarter_turns(RationalRotation rotation, const mpz_class& times) {
  for (unsigned long i = mpz_fdiv_ui(times.get_mpz_t(), 4); i > 0; --i)
    rotation = {-rotation.sin, rotation.cos};
  return rotation;
}

/// By an angle above 0 and up to 45 degrees. Of a fraction p/q in lowest terms for t, the rotation has
/// the denominator p² + q², or half of that where both are odd; and then 90 degrees less the angle has the
/// other form. So the smallest denominator is that of the simplest t for one of the two.
RationalRotation rotation_in_first_octant(const Rational& degrees, const Rational& error) {
  if (degrees <= error) return {};
  const RationalRotation there = simplest_half_tangent(degrees, error);
  const RationalRotation from_90 = simplest_half_tangent(90 - degrees, error);
  if (there.cos.get_den() <= from_90.cos.get_den()) return there;
  if (OPLUS_MUTANT("rotation-by-the-rest-of-a-right-angle",
                   "rotations are by 90 degrees less the angle, where that has smaller numbers"))
    return from_90;
  return {from_90.sin, from_90.cos};
}

}  // namespace

RationalRotation rational_rotation(const Rational& degrees, const Rational& error) {
  OPLUS_REQUIRES(error > 0, "rational_rotation");
  if (degrees < 0) {
    const RationalRotation opposite = rational_rotation(-degrees, error);
    return {opposite.cos, -opposite.sin};
  }
  const mpz_class quarters = floor_of(Rational(degrees / 90 + Rational(1, 2)));
  const Rational rest = degrees - 90 * quarters;
  if (rest == 0) return with_quarter_turns({}, quarters);
  RationalRotation rotation = rotation_in_first_octant(abs(rest), std::min(error, Rational(45)));
  if (rest < 0) rotation.sin = -rotation.sin;
  return with_quarter_turns(rotation, quarters);
}

Rational angle_in_degrees(const RationalRotation& rotation, const Rational& error) {
  OPLUS_REQUIRES(rotation.cos * rotation.cos + rotation.sin * rotation.sin == 1,
                 "angle_in_degrees");
  // Turned back until it is at most 45 degrees from none.
  int quarters = 0;
  RationalRotation rest = rotation;
  while (rest.cos < abs(rest.sin)) {
    const bool is_left = rest.sin > 0 || (rest.sin == 0 && rest.cos < 0);
    rest = with_quarter_turns(rest, is_left ? -1 : 1);
    quarters += is_left ? 1 : -1;
  }
  if (rest.sin == 0) return 90 * quarters;
  // 90 a / b for a = arctan t and b = π/4, both within `slack`: a / b <= 1/2, so it is off by less than
  // 90 (1 + 1/2) slack / (b - slack) < 256 slack units.
  const FixedPoint numbers(bits_for(error) + 16);
  const mpz_class a = numbers.arctangent(rest.sin / (1 + rest.cos));
  return 90 * quarters + 90 * Rational(a) / Rational(numbers.quarter_of_pi());
}

}  // namespace oplus
