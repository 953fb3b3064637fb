// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <cstddef>

namespace oplus {

inline mpz_class power_of_ten(std::size_t exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return power;
}

}  // namespace oplus
