// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "checked/arithmetic/filtered_direction.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// What tracing needs to know of a chain.
class TracedChain {
 public:
  /// Requires: no two consecutive vertices are equal.
  TracedChain(const Chain& chain, Summand of);

  std::size_t size() const { return edges_.size(); }
  const FilteredDirection& edge(std::size_t leaving) const { return edges_[leaving]; }
  bool is_reflex(std::size_t vertex) const { return corners_[vertex].is_reflex; }

  /// in_tangent_set, of a direction of the other summand and a vertex of this chain.
  bool has_in_tangent_set(std::size_t vertex, const FilteredDirection& d) const;

 private:
  struct Corner {
    bool is_reflex;
    int turn;  ///< compare(incoming edge, outgoing edge)
  };

  std::vector<FilteredDirection> edges_;
  std::vector<Corner> corners_;
};

/// A cycle in a fiber grid: from vertex i of P and vertex j of Q, each step goes on to the next
/// vertex of one of them, along that edge.
struct GridCycle {
  std::size_t i;
  std::size_t j;
  std::vector<Summand> steps;
};

struct GridCycles {
  std::vector<GridCycle> cycles;
  std::size_t states_looked_at = 0;  ///< n + m - 1 + K less the number of cycles
};

/// The cycles of the fiber grid (thesis, Definition 4.1.7) of two chains, traced by Algorithm 2 from
/// the unvisited segments that leave the states of the first row and the first column. Each segment
/// is in exactly one cycle (Theorems 4.1.6 and 4.1.10). O(n + m + K), that is O(K).
///
/// At most two segments leave a state, and as many enter it (Lemma 4.1.4). Where both that leave are
/// unvisited, Algorithm 2 may choose: here a cycle goes on along the summand it came by. So away
/// from its start, which segment follows depends on the segment before it alone, and on different
/// ones follow different ones; a cycle therefore cannot run into another, or into itself before it
/// is back, and no test whether a segment was visited is needed. Only those that leave starting
/// states are marked. Both are traced before the next start is looked at, so a start where two
/// cycles are joined otherwise is one that no later cycle enters.
GridCycles trace_cycles(const TracedChain& p, const TracedChain& q);

/// How large the convolution of two chains is, without keeping a step of it.
struct GridCounts {
  std::size_t segments = 0;
  std::size_t reduced_segments = 0;  ///< those whose vertex is not reflex
  std::size_t cycles = 0;
  std::size_t states_looked_at = 0;
};
GridCounts count_cycles(const TracedChain& p, const TracedChain& q);

}  // namespace oplus
