// SPDX-License-Identifier: MIT
#include "checked/cycles/cycle_tracing.hpp"

#include <array>
#include <utility>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus {

TracedChain::TracedChain(const Chain& chain, Summand of) {
  const std::size_t size = chain.size();
  edges_.reserve(size);
  corners_.reserve(size);
  for (std::size_t i = 0; i < size; ++i)
    edges_.emplace_back(Direction{chain[next(i, size)] - chain[i], of});
  for (std::size_t i = 0; i < size; ++i) {
    const FilteredDirection& in = edges_[previous(i, size)];
    const FilteredDirection& out = edges_[i];
    const int turn = compare(in, out);
    const bool is_reflex =
        OPLUS_MUTANT("reflex-where-angles-decrease",
                     "a vertex is taken for reflex where its outgoing edge has the smaller angle")
            ? turn > 0
            : oplus::is_reflex({in.exact().vector, out.exact().vector});
    corners_.push_back({is_reflex, turn});
  }
}

bool TracedChain::has_in_tangent_set(std::size_t vertex, const FilteredDirection& d) const {
  const int turn = corners_[vertex].turn;
  if (turn == 0) return false;
  const bool after_in = compare(edges_[previous(vertex, size())], d) < 0;
  if (after_in != (turn < 0)) return after_in;
  return compare(d, edges_[vertex]) < 0;
}

namespace {

struct State {
  std::size_t i;
  std::size_t j;

  friend bool operator==(const State&, const State&) = default;
};

/// `Cycles` is told of each cycle that starts, and then of its steps in turn.
template <typename Cycles>
class Tracer {
 public:
  Tracer(const TracedChain& p, const TracedChain& q, Cycles& cycles)
      : p_(p), q_(q), cycles_(cycles), visited_in_row_(p.size()), visited_in_column_(q.size()) {}

  /// Returns how many states it looked at.
  std::size_t run() {
    for (std::size_t i = 0; i < p_.size(); ++i) start_at({i, 0});
    if (OPLUS_MUTANT("no-start-in-the-first-column",
                     "tracing starts from the states of one row only"))
      return states_looked_at_;
    for (std::size_t j = 1; j < q_.size(); ++j) start_at({0, j});
    for (std::size_t i = 1; OPLUS_MUTANT("every-state-is-a-start",
                                         "tracing starts from every state of the fiber grid") &&
                            i < p_.size();
         ++i)
      for (std::size_t j = 1; j < q_.size(); ++j) start_at({i, j});
    return states_looked_at_;
  }

 private:
  /// Whether the sum of the state's vertex of one summand and the edge that leaves the other's is in
  /// the convolution: inc_p and inc_q of Algorithm 2.
  bool leaves_along(Summand edge_of, const State& at) const {
    return edge_of == Summand::P ? q_.has_in_tangent_set(at.j, p_.edge(at.i))
                                 : p_.has_in_tangent_set(at.i, q_.edge(at.j));
  }

  void start_at(const State& start) {
    ++states_looked_at_;
    for (const Summand edge_of : {Summand::P, Summand::Q})
      if (leaves_along(edge_of, start) && !visited(edge_of, start)) trace(start, edge_of);
  }

  void trace(const State& start, Summand edge_of) {
    cycles_.start(start);
    State at = start;
    for ([[maybe_unused]] std::size_t steps = 1;; ++steps) {
      mark_visited(edge_of, at);
      cycles_.step(edge_of, at);
      OPLUS_ENSURES(steps <= 2 * p_.size() * q_.size(), "Theorem 4.1.6");
      std::size_t& index = edge_of == Summand::P ? at.i : at.j;
      index = next(index, edge_of == Summand::P ? p_.size() : q_.size());
      if (at == start ||
          (OPLUS_MUTANT(
               "cycle-ends-in-its-column",
               "a cycle ends when it is back in the column of its start, whatever the row") &&
           at.i == start.i))
        return;
      edge_of = summand_after(edge_of, at);
    }
  }

  /// Which edge a cycle takes that came to a state along this summand's. If it cannot go on, it need
  /// not test whether it can turn; Algorithm 2 does not either.
  Summand summand_after(Summand came_by, const State& at) {
    ++states_looked_at_;
    if (OPLUS_MUTANT("edge-of-p-though-visited",
                     "where both segments leave a state, tracing takes P's, visited or not"))
      came_by = Summand::P;
    if (leaves_along(came_by, at)) return came_by;
    OPLUS_ENSURES(leaves_along(other(came_by), at), "Lemma 4.1.3");
    return other(came_by);
  }

  /// Of a starting state, for its two outgoing segments; of any other, nothing is kept.
  std::array<bool, 2>* marks(const State& at) {
    if (at.j == 0) return &visited_in_row_[at.i];
    return at.i == 0 ? &visited_in_column_[at.j] : nullptr;
  }

  bool visited(Summand edge_of, const State& start) {
    const std::array<bool, 2>* of_state = marks(start);
    return of_state == nullptr || (*of_state)[static_cast<std::size_t>(edge_of)];
  }

  void mark_visited(Summand edge_of, const State& at) {
    if (std::array<bool, 2>* of_state = marks(at)) {
      bool& mark = (*of_state)[static_cast<std::size_t>(edge_of)];
      OPLUS_ENSURES(!mark, "Theorem 4.1.6");
      mark = true;
    }
  }

  const TracedChain& p_;
  const TracedChain& q_;
  Cycles& cycles_;
  std::vector<std::array<bool, 2>> visited_in_row_;
  std::vector<std::array<bool, 2>> visited_in_column_;
  std::size_t states_looked_at_ = 0;
};

struct KeptCycles {
  GridCycles result;

  void start(const State& at) { result.cycles.push_back({at.i, at.j, {}}); }
  void step(Summand edge_of, const State&) { result.cycles.back().steps.push_back(edge_of); }
};

struct CountedCycles {
  const TracedChain& p;
  const TracedChain& q;
  GridCounts result;

  void start(const State&) { ++result.cycles; }
  void step(Summand edge_of, const State& at) {
    ++result.segments;
    const bool at_reflex = edge_of == Summand::P ? q.is_reflex(at.j) : p.is_reflex(at.i);
    if (!at_reflex) ++result.reduced_segments;
  }
};

}  // namespace

GridCycles trace_cycles(const TracedChain& p, const TracedChain& q) {
  KeptCycles cycles;
  const std::size_t states = Tracer(p, q, cycles).run();
  cycles.result.states_looked_at = states;
  return std::move(cycles.result);
}

GridCounts count_cycles(const TracedChain& p, const TracedChain& q) {
  CountedCycles cycles{p, q, {}};
  const std::size_t states = Tracer(p, q, cycles).run();
  cycles.result.states_looked_at = states;
  return cycles.result;
}

}  // namespace oplus
