// SPDX-License-Identifier: MIT
#include "checked/cycles/convolution_cycles.hpp"

#include <iterator>
#include <utility>

#include "checked/cycles/cycle_tracing.hpp"
#include "reference/chains/nesting.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

std::vector<TracedChain> traced(const std::vector<const Chain*>& chains, Summand of) {
  std::vector<TracedChain> result;
  result.reserve(chains.size());
  for (const Chain* chain : chains) result.emplace_back(*chain, of);
  return result;
}

/// result = a + b, without the cost of fractions where both are integers.
/// Requires: result is an integer.
void add(const Rational& a, const Rational& b, Rational& result) {
  if (a.get_den() == 1 && b.get_den() == 1)
    result.get_num() = a.get_num() + b.get_num();
  else
    result = a + b;
}

void add(const Point& a, const Point& b, Point& result) {
  add(a.x, b.x, result.x);
  add(a.y, b.y, result.y);
}

/// The cycles of all pairs of chains of two regions, to which it refers, as steps in fiber grids.
/// Points are added only where someone wants a segment.
class Tracing {
 public:
  struct Pair {
    std::size_t a;  ///< chain of P
    std::size_t b;  ///< chain of Q
    GridCycles grid;
  };

  Tracing(const Region& p, const Region& q)
      : p_(chains_in(p)),
        q_(chains_in(q)),
        traced_p_(traced(p_, Summand::P)),
        traced_q_(traced(q_, Summand::Q)) {
    for (std::size_t a = 0; a < p_.size(); ++a)
      for (std::size_t b = 0; b < q_.size(); ++b)
        if (!OPLUS_MUTANT("holes-of-q-are-left-out",
                          "cycles are traced along the outer chains of Q only") ||
            sign(twice_area(*q_[b])) > 0)
          pairs_.push_back({a, b, trace_cycles(traced_p_[a], traced_q_[b])});
  }

  const std::vector<Pair>& pairs() const { return pairs_; }

  /// Calls `action` on the segments of a cycle in turn.
  template <typename Action>
  void for_each_step(const Pair& pair, const GridCycle& cycle, Action action) const {
    std::size_t i = cycle.i;
    std::size_t j = cycle.j;
    for (const Summand edge_of : cycle.steps) {
      const VertexIndex of_p{pair.a, i};
      const VertexIndex of_q{pair.b, j};
      if (edge_of == Summand::P) {
        action(TracedOrigin{{edge_of, of_p, of_q}, traced_q_[pair.b].is_reflex(j)});
        i = next(i, p_[pair.a]->size());
      } else {
        action(TracedOrigin{{edge_of, of_q, of_p}, traced_p_[pair.a].is_reflex(i)});
        j = next(j, q_[pair.b]->size());
      }
    }
  }

  /// Writes in place: points are neither copied nor moved.
  void make_segment(const TracedOrigin& step, ConvolutionSegment& result) const {
    const auto& [edge_of, edge, vertex] = step.origin;
    const bool of_p = edge_of == Summand::P;
    const Chain& with_edge = *(of_p ? p_ : q_)[edge.chain];
    const Point& at = (*(of_p ? q_ : p_)[vertex.chain])[vertex.vertex];
    add(with_edge[edge.vertex], at, result.segment.source);
    add(with_edge[next(edge.vertex, with_edge.size())], at, result.segment.target);
    result.origin = step.origin;
    result.vertex_is_reflex = step.vertex_is_reflex;
  }

  template <typename IsKept>
  std::vector<TracedOrigin> origins(IsKept is_kept) const {
    std::vector<TracedOrigin> result;
    for (const Pair& pair : pairs_) {
      for (const GridCycle& cycle : pair.grid.cycles) {
        for_each_step(pair, cycle, [&](const TracedOrigin& step) {
          if (is_kept(step)) result.push_back(step);
        });
      }
    }
    return result;
  }

  std::vector<ConvolutionSegment> segments(const std::vector<TracedOrigin>& origins) const {
    std::vector<ConvolutionSegment> result(origins.size());
    for (std::size_t k = 0; k < origins.size(); ++k) make_segment(origins[k], result[k]);
    return result;
  }

 private:
  std::vector<const Chain*> p_;
  std::vector<const Chain*> q_;
  std::vector<TracedChain> traced_p_;
  std::vector<TracedChain> traced_q_;
  std::vector<Pair> pairs_;
};

bool is_in_full(const TracedOrigin&) { return true; }
bool is_in_reduced(const TracedOrigin& segment) { return !segment.vertex_is_reflex; }

}  // namespace

ConvolutionCycles convolution_cycles(const Region& p, const Region& q) {
  const Tracing tracing(p, q);
  ConvolutionCycles result;
  for (const Tracing::Pair& pair : tracing.pairs()) {
    result.steps += pair.grid.states_looked_at;
    for (const GridCycle& cycle : pair.grid.cycles) {
      ConvolutionCycle& segments = result.cycles.emplace_back(cycle.steps.size());
      std::size_t k = 0;
      tracing.for_each_step(pair, cycle, [&](const TracedOrigin& step) {
        tracing.make_segment(step, segments[k++]);
      });
    }
  }
  return result;
}

ConvolutionSize convolution_size(const Region& p, const Region& q) {
  const std::vector<TracedChain> traced_p = traced(chains_in(p), Summand::P);
  const std::vector<TracedChain> traced_q = traced(chains_in(q), Summand::Q);
  ConvolutionSize size;
  for (const TracedChain& a : traced_p) {
    for (const TracedChain& b : traced_q) {
      const GridCounts of_pair = count_cycles(a, b);
      size.segments += of_pair.segments;
      size.reduced_segments += of_pair.reduced_segments;
      size.cycles += of_pair.cycles;
      size.steps += of_pair.states_looked_at;
    }
  }
  return size;
}

std::vector<ConvolutionSegment> full_convolution(ConvolutionCycles cycles) {
  std::vector<ConvolutionSegment> result;
  std::size_t size = 0;
  for (const ConvolutionCycle& cycle : cycles.cycles) size += cycle.size();
  result.reserve(size);
  for (ConvolutionCycle& cycle : cycles.cycles)
    result.insert(result.end(), std::make_move_iterator(cycle.begin()),
                  std::make_move_iterator(cycle.end()));
  return result;
}

std::vector<ConvolutionSegment> reduced_convolution(ConvolutionCycles cycles) {
  std::vector<ConvolutionSegment> result = full_convolution(std::move(cycles));
  std::erase_if(result, [](const ConvolutionSegment& s) { return s.vertex_is_reflex; });
  return result;
}

std::vector<ConvolutionSegment> traced_convolution(const Region& p, const Region& q) {
  const Tracing tracing(p, q);
  return tracing.segments(tracing.origins(is_in_full));
}

std::vector<ConvolutionSegment> traced_reduced_convolution(const Region& p, const Region& q) {
  const Tracing tracing(p, q);
  return tracing.segments(tracing.origins(is_in_reduced));
}

std::vector<TracedOrigin> traced_origins(const Region& p, const Region& q) {
  return Tracing(p, q).origins(is_in_full);
}

}  // namespace oplus
