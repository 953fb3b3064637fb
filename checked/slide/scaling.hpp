// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "reference/definitions/region.hpp"

namespace oplus::slide {

/// Faster than == 1. Requires: value > 0.
inline bool is_one(const mpz_class& value) {
  return mpz_size(value.get_mpz_t()) == 1 && mpz_getlimbn(value.get_mpz_t(), 0) == 1;
}

/// How two summands become integers: their coordinates times a common denominator and, where that
/// would take more than 29 bits, less the middle of their boxes.
struct Scaling {
  struct Offset {
    mpz_class x = 0;
    mpz_class y = 0;
  };

  mpz_class denominator = 1;
  Offset of_p = {};
  Offset of_q = {};
  std::size_t bits = 1;   ///< of the largest coordinate then
  std::size_t shift = 0;  ///< coordinates are near to doubles times 2^shift

  bool is_trivial() const { return is_one(denominator) && bits <= 29 && !is_moved; }
  bool is_moved = false;

  /// A point of the scaled sum, in lowest terms or not, becomes one of the sum, in lowest terms.
  void put_back(Point& point) const;
};

/// What the scaling of a pair depends on, of each of them.
struct Extent {
  mpz_class denominator = 1;  ///< common to all coordinates
  bool is_unlike = false;     ///< that is not, since it would have many more bits than any of them
  std::size_t longest = 31;   ///< the bits of the longest numerator or denominator, or 31
  Point low, high;            ///< corners of the box
};

/// Whether a common denominator may have as many bits as it takes.
enum class Denominators { alike, any };

/// Of a region without vertices, the box is the origin.
Extent extent_of(const Region& region, Denominators denominators = Denominators::alike);

/// Whether the common denominator has many more bits than any coordinate, so that computing with
/// rationals is faster.
bool has_unlike_denominators(const Extent& p, const Extent& q);

/// Requires: neither is unlike.
Scaling scaling_of(const Extent& p, const Extent& q);

/// The same of two regions whose coordinates are integers of so many bits, at most 29.
inline Scaling scaling_of_integers(std::size_t bits) {
  Scaling scaling;
  scaling.bits = bits;
  return scaling;
}

/// The bits of the largest coordinate, at least 1, if all are integers, else 0.
std::size_t bits_of_integers(const Region& region);

/// For RationalNumbers: the denominator is a power of two, with which coordinates have about 60 bits
/// before the point. Requires: both have a vertex.
Scaling scaling_of_rationals(const Region& p, const Region& q);

/// A coordinate as an integer.
mpz_class scaled(const Rational& coordinate, const Scaling& scaling, const mpz_class& offset);

}  // namespace oplus::slide
