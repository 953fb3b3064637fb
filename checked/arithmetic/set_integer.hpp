// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>

namespace oplus {

__extension__ using Integer128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

/// Sets a number of GMP, whose own functions take a long, which has 32 bits on some machines.
inline void set_integer(mpz_ptr number, Integer128 value) {
  if (value == static_cast<long>(value)) return mpz_set_si(number, static_cast<long>(value));
  const auto size = value < 0 ? -static_cast<Unsigned128>(value) : static_cast<Unsigned128>(value);
  const std::array<std::uint64_t, 2> words = {static_cast<std::uint64_t>(size),
                                              static_cast<std::uint64_t>(size >> 64)};
  mpz_import(number, words.size(), -1, sizeof(std::uint64_t), 0, 0, words.data());
  if (value < 0) mpz_neg(number, number);
}

}  // namespace oplus
