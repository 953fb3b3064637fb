// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/computed_sum.hpp"

namespace oplus {

/// The arithmetic of a run. Larger numbers than are needed are slower, and change nothing.
enum class SlideNumbers { as_needed, at_least_256_bits, gmp };

struct SlideOptions {
  WithOrigins with_origins = WithOrigins::no;
  unsigned threads = 1;  ///< at least 1; the result does not depend on it
  SlideNumbers numbers = SlideNumbers::as_needed;
};

/// What a run of slide did. It does not depend on the number of threads either.
struct SlideStatistics {
  std::size_t segments = 0;     ///< of the reduced convolution
  std::size_t bits = 0;         ///< of the largest coordinate as an integer
  std::size_t probes = 0;       ///< places asked for a pair of edges that blocks them
  std::size_t box_pairs = 0;    ///< looked at for that
  std::size_t by_doubles = 0;   ///< pairs of edges that doubles told not to block
  std::size_t in_64_bits = 0;   ///< pairs of edges that took integers of 64 bits,
  std::size_t in_256_bits = 0;  ///< of 256 bits,
  std::size_t in_gmp = 0;       ///< or of any length
  std::size_t free_pieces = 0;  ///< of segments, on the boundary
};

struct SlideResult {
  MinkowskiSum sum;
  Origins origins;  ///< empty unless asked for
  SlideStatistics statistics;
};

/// Computes P ⊕ Q from the reduced convolution without an arrangement: docs/slide.md.
/// Requires: p and q are valid (validity.hpp).
SlideResult slide_sum(const Region& p, const Region& q, Boundary boundary,
                      const SlideOptions& options = {});

}  // namespace oplus
