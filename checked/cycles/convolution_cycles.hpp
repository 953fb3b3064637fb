// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "reference/definitions/convolution.hpp"

namespace oplus {

/// A convolution cycle (thesis, Definition 4.1.1): each segment starts where the one before it ends,
/// the first where the last does. Consecutive segments are consecutive states of Algorithm 2.
using ConvolutionCycle = std::vector<ConvolutionSegment>;

struct ConvolutionCycles {
  /// Together, each segment of 𝒞 exactly once (thesis, Lemma 4.1.5).
  std::vector<ConvolutionCycle> cycles;

  /// States looked at: those of the starting rows and columns, and each one that a cycle passes
  /// between its start and its return there. With K segments, less than n + m + K for two chains,
  /// and less than 2 K for any two regions, unless one is empty (thesis, Theorem 4.1.10).
  std::size_t steps = 0;
};

/// Finds 𝒞 by tracing its cycles: Algorithm 2 on the fiber grid (thesis, Definition 4.1.7) of each
/// pair of chains, started from one row and one column. O(n + m + K). Same regions, same order.
/// Requires: p and q are valid (validity.hpp).
ConvolutionCycles convolution_cycles(const Region& p, const Region& q);

/// How large 𝒞 is.
struct ConvolutionSize {
  std::size_t segments = 0;
  std::size_t reduced_segments = 0;  ///< of the reduced convolution (thesis, Definition 2.3.1)
  std::size_t cycles = 0;
  std::size_t steps = 0;  ///< to trace them, as above
};

/// Returns what there would be to count in convolution_cycles(p, q). It is traced, but nothing is kept of it:
/// O(n + m + K) time, O(n + m) memory. Requires: p and q are valid (validity.hpp).
ConvolutionSize convolution_size(const Region& p, const Region& q);

/// The segments of all cycles, cycle by cycle: 𝒞.
std::vector<ConvolutionSegment> full_convolution(ConvolutionCycles cycles);

/// Those whose vertex is not reflex: the reduced convolution (thesis, Definition 2.3.1).
std::vector<ConvolutionSegment> reduced_convolution(ConvolutionCycles cycles);

/// The same, in the same order, without the cycles: each segment that is returned is made once, and
/// no other.
std::vector<ConvolutionSegment> traced_convolution(const Region& p, const Region& q);
std::vector<ConvolutionSegment> traced_reduced_convolution(const Region& p, const Region& q);

/// A convolution segment of which no point has been computed.
struct TracedOrigin {
  Origin origin;
  bool vertex_is_reflex;
};

/// Those of traced_convolution, in its order. Exact points are what takes the time: without them 𝒞
/// costs about a tenth.
std::vector<TracedOrigin> traced_origins(const Region& p, const Region& q);

}  // namespace oplus
