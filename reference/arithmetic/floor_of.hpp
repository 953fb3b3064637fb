// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/rational.hpp"

namespace oplus {

/// The largest integer that is not above numerator / denominator. Requires: denominator is not 0.
inline mpz_class floor_of(const mpz_class& numerator, const mpz_class& denominator) {
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  return result;
}

/// The largest integer that is not above x.
inline mpz_class floor_of(const Rational& x) { return floor_of(x.get_num(), x.get_den()); }

}  // namespace oplus
