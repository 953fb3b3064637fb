// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>

#include "reference/definitions/convolution.hpp"

namespace oplus {

/// A state of Algorithm 2: a vertex of P at a vertex of Q (thesis, Section 4.1.1).
struct State {
  VertexIndex p;
  VertexIndex q;

  friend auto operator<=>(const State&, const State&) = default;
};

/// The state that a convolution segment leaves.
inline State state_before(const Origin& origin) {
  return origin.edge_of == Summand::P ? State{origin.edge, origin.vertex}
                                      : State{origin.vertex, origin.edge};
}

/// The state that it leads to. Requires: the chains of P and of Q.
inline State state_after(const Origin& origin, const std::vector<Chain>& of_p,
                         const std::vector<Chain>& of_q) {
  State state = state_before(origin);
  if (origin.edge_of == Summand::P)
    state.p.vertex = next(state.p.vertex, of_p[state.p.chain].size());
  else
    state.q.vertex = next(state.q.vertex, of_q[state.q.chain].size());
  return state;
}

}  // namespace oplus
