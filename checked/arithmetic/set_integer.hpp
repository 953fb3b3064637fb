// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace oplus {

__extension__ using Integer128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

/// Sets a number of GMP, given the words of its absolute value, the lowest first.
template <typename Word>
void set_integer(mpz_ptr number, const Word* words, std::size_t size, bool is_negative) {
  mpz_import(number, size, -1, sizeof(Word), 0, 0, words);
  if (is_negative) mpz_neg(number, number);
}

/// The same of an integer: GMP's own functions take a long, which has 32 bits on some machines.
inline void set_integer(mpz_ptr number, Integer128 value) {
  if (value == static_cast<long>(value)) return mpz_set_si(number, static_cast<long>(value));
  const auto size = value < 0 ? -static_cast<Unsigned128>(value) : static_cast<Unsigned128>(value);
  const std::array<std::uint64_t, 2> words = {static_cast<std::uint64_t>(size),
                                              static_cast<std::uint64_t>(size >> 64)};
  set_integer(number, words.data(), words.size(), value < 0);
}

}  // namespace oplus
