// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <string>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// A digest of sums in any order: those of two shards add up to that of both.
class SumDigest {
 public:
  /// Nothing yet.
  SumDigest() = default;

  /// As to_string() wrote it. Throws std::invalid_argument.
  explicit SumDigest(const std::string& hexadecimal);

  /// Adds the sums of a pair, told apart from other pairs by its index.
  void add(std::size_t pair, const PlanarSet& closed, const PlanarSet& open);
  void add(const SumDigest& other);

  /// 32 hexadecimal digits.
  std::string to_string() const;

  friend bool operator==(const SumDigest&, const SumDigest&) = default;

 private:
  mpz_class sum_;  ///< of hashes, modulo 2^128
};

}  // namespace oplus
