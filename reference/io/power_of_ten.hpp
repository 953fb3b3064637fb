// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

namespace oplus {

inline mpz_class power_of_ten(unsigned long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
  return power;
}

}  // namespace oplus
