// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <string>

#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/values.hpp"

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

// Lines for reports, in WKT where that can hold the value.

/// An unbounded region is in the form of .dat.
std::string in_words(const Region& region);

/// A sum that is no region, or is unbounded, is listed by its chains, edges and points.
std::string in_words(const PlanarSet& sum);

}  // namespace oplus
