// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "reference/definitions/convolution.hpp"

namespace oplus {

/// The fiber grid of two chains (thesis, Definition 4.1.7): a node for each state (i, j), vertex i of
/// P at vertex j of Q; an edge for each convolution segment, to the state in which the next vertex of
/// P, or of Q, takes its turn. Both indices are cyclic.
struct FiberGrid {
  struct Edge {
    std::size_t i;  ///< from this state
    std::size_t j;
    Summand along;      ///< to the next vertex of this summand
    std::size_t cycle;  ///< which of the traced cycles it is in

    friend bool operator==(const Edge&, const Edge&) = default;
  };

  std::size_t n;            ///< vertices of P's chain
  std::size_t m;            ///< vertices of Q's chain
  std::size_t cycles;       ///< how many
  std::vector<Edge> edges;  ///< cycle by cycle, each in its own order
};

/// The grid of two chains, its edges in the cycles that Algorithm 2 traces. O(n + m + K).
/// Requires: chains of valid regions, outer ones counterclockwise, holes clockwise.
FiberGrid fiber_grid(const Chain& p, const Chain& q);

}  // namespace oplus
