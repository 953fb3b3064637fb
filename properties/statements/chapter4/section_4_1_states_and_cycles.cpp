// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <compare>
#include <map>
#include <set>
#include <utility>

#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/directions_around.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/tangent_set.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// A state of Algorithm 2: a vertex of P at a vertex of Q (thesis, Section 4.1.1).
struct State {
  VertexIndex p;
  VertexIndex q;

  friend auto operator<=>(const State&, const State&) = default;
};

/// The state that a convolution segment leaves.
State state_before(const Origin& origin) {
  return origin.edge_of == Summand::P ? State{origin.edge, origin.vertex}
                                      : State{origin.vertex, origin.edge};
}

/// The state that it leads to. Requires: the chains of P and of Q.
State state_after(const Origin& origin, const std::vector<Chain>& of_p,
                  const std::vector<Chain>& of_q) {
  State state = state_before(origin);
  if (origin.edge_of == Summand::P)
    state.p.vertex = next(state.p.vertex, of_p[state.p.chain].size());
  else
    state.q.vertex = next(state.q.vertex, of_q[state.q.chain].size());
  return state;
}

/// How many convolution segments enter a state, and how many leave it: up to two each.
struct Traffic {
  int entering = 0;
  int leaving = 0;
};

std::string in_words(const Traffic& traffic) {
  return "segments that enter the state: " + std::to_string(traffic.entering) +
         ", that leave it: " + std::to_string(traffic.leaving);
}

/// Both parts of the lemma.
bool goes_on(const Traffic& traffic) {
  const bool first = traffic.entering == 0 || traffic.leaving > 0;
  const bool second = (traffic.leaving == 2) == (traffic.entering == 2);
  return first && second;
}

/// At a state whose vertices have these corners: which segments are in the convolution depends on
/// nothing else.
Traffic traffic_at(const Corner& of_p, const Corner& of_q) {
  const auto in_convolution = [](const Vector& edge, Summand of, const Corner& vertex) {
    return in_tangent_set({edge, of}, vertex) ? 1 : 0;
  };
  return {in_convolution(of_p.in, Summand::P, of_q) + in_convolution(of_q.in, Summand::Q, of_p),
          in_convolution(of_p.out, Summand::P, of_q) + in_convolution(of_q.out, Summand::Q, of_p)};
}

Enumeration enumerate() {
  const DirectionsAround directions(5);
  Enumeration result;
  for_each_choice<4>(directions.size(), [&](const std::array<std::size_t, 4>& choice) {
    const Corner of_p{directions[choice[0]], directions[choice[1]]};
    const Corner of_q{directions[choice[2]], directions[choice[3]]};
    const Traffic traffic = traffic_at(of_p, of_q);
    ++result.cases;
    // More than the lemma says: a state that nothing enters is not left.
    if (!result.failure.empty() || (goes_on(traffic) && traffic.entering == traffic.leaving))
      return;
    result.failure = "where P's vertex has edges " + to_string(of_p.in) + " and " +
                     to_string(of_p.out) + " and Q's " + to_string(of_q.in) + " and " +
                     to_string(of_q.out) + ", " + in_words(traffic);
  });
  return result;
}

Outcome check_forward_traversal(const Summands& summands) {
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  std::map<State, Traffic> traffic;
  for (const ConvolutionSegment& s : convolution(summands.p, summands.q)) {
    ++traffic[state_before(s.origin)].leaving;
    ++traffic[state_after(s.origin, of_p, of_q)].entering;
  }
  Outcome outcome;
  for (const ConvolutionCycle& cycle : convolution_cycles(summands.p, summands.q).cycles) {
    for (const ConvolutionSegment& s : cycle) {
      const Traffic& here = traffic[state_after(s.origin, of_p, of_q)];
      ++outcome.counts["states while tracing"];
      if (here.leaving == 2) ++outcome.counts["of these with two ways on"];
      if (goes_on(here) && here.entering > 0) continue;
      return outcome.fail("at " + to_string(s.segment.target) + " " + in_words(here),
                          s.segment.target);
    }
  }
  return outcome;
}

const Registered lemma_4_1_3(larger_mixture(),
                             {.id = "lemma-4.1.3",
                              .kills = {"tangent-set-without-ties", "tie-rule-depends-on-who-asks",
                                        "reflex-turns-clockwise"},
                              .cases = 1000,
                              .check = check_forward_traversal,
                              .enumerate = enumerate});

/// What is wrong with a cycle, or empty.
std::string defect(const ConvolutionCycle& cycle, const std::vector<Chain>& of_p,
                   const std::vector<Chain>& of_q) {
  if (cycle.empty()) return "a cycle has no segment";
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const ConvolutionSegment& here = cycle[k];
    const ConvolutionSegment& after = cycle[next(k, cycle.size())];
    const std::string where = "after segment " + std::to_string(k) + " of " +
                              std::to_string(cycle.size()) + " a cycle goes on ";
    if (here.segment.target != after.segment.source) return where + "at another point";
    if (state_after(here.origin, of_p, of_q) != state_before(after.origin))
      return where + "in another state";
  }
  return {};
}

Outcome check_cycles(const Summands& summands) {
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  const ConvolutionCycles traced = convolution_cycles(summands.p, summands.q);
  std::set<Origin> missing;
  for (const ConvolutionSegment& s : convolution(summands.p, summands.q)) missing.insert(s.origin);
  Outcome outcome;
  outcome.counts = {{"cycles", traced.cycles.size()}, {"segments", missing.size()}};
  for (const ConvolutionCycle& cycle : traced.cycles) {
    if (outcome.why.empty()) outcome.why = defect(cycle, of_p, of_q);
    for (const ConvolutionSegment& s : cycle)
      if (missing.erase(s.origin) == 0 && outcome.why.empty())
        outcome.why = "a segment is in two cycles, or twice in one, or not in the convolution";
  }
  if (outcome.why.empty() && !missing.empty()) outcome.why = "a segment is in no cycle";
  if (!outcome.why.empty()) outcome.kind = Outcome::Kind::fails;
  return outcome;
}

const Registered theorem_4_1_6(larger_mixture(),
                               {.id = "theorem-4.1.6",
                                .kills = {"cycle-ends-in-its-column", "edge-of-p-though-visited",
                                          "no-start-in-the-first-column"},
                                .cases = 1500,
                                .check = check_cycles});

/// How many edges of each summand a cycle has.
struct Size {
  std::size_t of_p = 0;
  std::size_t of_q = 0;
};

Size size_of(const ConvolutionCycle& cycle) {
  const auto of_p = static_cast<std::size_t>(std::count_if(
      cycle.begin(), cycle.end(), [](const auto& s) { return s.origin.edge_of == Summand::P; }));
  return {of_p, cycle.size() - of_p};
}

/// The cycles of each pair of chains.
using CyclesOfPairs = std::map<std::pair<std::size_t, std::size_t>, std::vector<Size>>;

CyclesOfPairs cycles_of_pairs(const ConvolutionCycles& traced) {
  CyclesOfPairs result;
  for (const ConvolutionCycle& cycle : traced.cycles) {
    const State first = state_before(cycle.front().origin);
    result[{first.p.chain, first.q.chain}].push_back(size_of(cycle));
  }
  return result;
}

/// What is wrong with the cycles of two chains, or empty.
std::string defect(const std::vector<Size>& cycles, const Chain& p, const Chain& q) {
  const std::size_t n = p.size(), m = q.size();
  if (std::any_of(cycles.begin(), cycles.end(),
                  [&](const Size& c) { return c.of_p % n != 0 || c.of_q % m != 0; }))
    return "a cycle does not go around each chain a whole number of times";
  if (std::none_of(cycles.begin(), cycles.end(),
                   [](const Size& c) { return c.of_p > 0 && c.of_q > 0; }))
    return "no cycle goes around both chains";
  if (is_convex(p) && is_convex(q) && cycles.size() > 1)
    return "two convex chains have more than one cycle";
  return {};
}

Outcome check_sizes_of_cycles(const Summands& summands) {
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  const CyclesOfPairs cycles = cycles_of_pairs(convolution_cycles(summands.p, summands.q));
  Outcome outcome;
  std::size_t without = 0;
  for (std::size_t a = 0; a < of_p.size(); ++a) {
    for (std::size_t b = 0; b < of_q.size(); ++b) {
      const auto of_pair = cycles.find({a, b});
      const std::vector<Size> sizes =
          of_pair == cycles.end() ? std::vector<Size>{} : of_pair->second;
      const std::string why = defect(sizes, of_p[a], of_q[b]);
      if (!why.empty()) outcome = {Outcome::Kind::fails, why, {}};
      if (std::none_of(sizes.begin(), sizes.end(), [&](const Size& c) {
            return c.of_p + c.of_q == of_p[a].size() + of_q[b].size();
          }))
        ++without;
    }
  }
  outcome.counts = {{"pairs of chains", of_p.size() * of_q.size()},
                    {"pairs of chains without a cycle of n + m segments", without}};
  return outcome;
}

const Registered corollary_4_1_9(larger_mixture(), {.id = "corollary-4.1.9",
                                                    .kills = {"cycle-ends-in-its-column"},
                                                    .cases = 1500,
                                                    .check = check_sizes_of_cycles});

/// Whether a cycle has a state in every row, or one in every column, of its fiber grid.
bool crosses_the_grid(const ConvolutionCycle& cycle, const std::vector<Chain>& of_p,
                      const std::vector<Chain>& of_q) {
  std::set<VertexIndex> of_p_met, of_q_met;
  for (const ConvolutionSegment& s : cycle) {
    const State state = state_before(s.origin);
    of_p_met.insert(state.p);
    of_q_met.insert(state.q);
  }
  const State first = state_before(cycle.front().origin);
  return of_p_met.size() == of_p[first.p.chain].size() ||
         of_q_met.size() == of_q[first.q.chain].size();
}

Outcome check_tracing_in_linear_time(const Summands& summands) {
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  const std::size_t n = vertex_count(summands.p), m = vertex_count(summands.q);
  const std::size_t k = convolution(summands.p, summands.q).size();
  const auto [cycles, steps] = convolution_cycles(summands.p, summands.q);
  Outcome outcome;
  if (n == 0 || m == 0) return {Outcome::Kind::discarded, "a summand is empty", {}};
  outcome.counts = {{"steps", steps}, {"segments", k}, {"states of all grids", n * m}};
  for (const ConvolutionCycle& cycle : cycles)
    if (!crosses_the_grid(cycle, of_p, of_q))
      outcome.why = "a cycle leaves out a row and a column of its fiber grid";
  if (of_p.size() == 1 && of_q.size() == 1 && steps >= n + m + k)
    outcome.why =
        std::to_string(steps) + " steps are not less than n + m + K = " + std::to_string(n + m + k);
  if (steps >= 2 * k)
    outcome.why = std::to_string(steps) + " steps are not less than 2 K = " + std::to_string(2 * k);
  if (!outcome.why.empty()) outcome.kind = Outcome::Kind::fails;
  return outcome;
}

const Registered theorem_4_1_10(larger_mixture(),
                                {.id = "theorem-4.1.10",
                                 .kills = {"cycle-ends-in-its-column", "every-state-is-a-start"},
                                 .cases = 1500,
                                 .check = check_tracing_in_linear_time});

/// How many tangent sets of a chain contain a direction: the same for every direction. An outer
/// chain turns by 2π, a hole by -2π; a reflex vertex turns clockwise by less than π, but its
/// tangent set is the rest of the circle, counterclockwise: one full turn more.
std::ptrdiff_t times_covered(const Chain& chain) {
  std::ptrdiff_t reflex = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) reflex += is_reflex(corner_at(chain, i)) ? 1 : 0;
  return sign(twice_area(chain)) + reflex;
}

/// The segments made of one edge and the vertices of one chain.
using Group = std::tuple<Summand, VertexIndex, std::size_t>;

void expect(Summand edge_of, const Region& with_edges, const Region& with_vertices,
            std::map<Group, std::ptrdiff_t>& missing) {
  const std::vector<Chain> of_edges = chains(with_edges), of_vertices = chains(with_vertices);
  for (std::size_t a = 0; a < of_edges.size(); ++a)
    for (std::size_t i = 0; i < of_edges[a].size(); ++i)
      for (std::size_t b = 0; b < of_vertices.size(); ++b)
        missing[{edge_of, {a, i}, b}] = times_covered(of_vertices[b]);
}

Outcome check_convolution_size(const Summands& summands) {
  std::map<Group, std::ptrdiff_t> missing;
  expect(Summand::P, summands.p, summands.q, missing);
  expect(Summand::Q, summands.q, summands.p, missing);
  const std::vector<ConvolutionSegment> all = convolution(summands.p, summands.q);
  for (const ConvolutionSegment& s : all)
    --missing[{s.origin.edge_of, s.origin.edge, s.origin.vertex.chain}];
  Outcome outcome;
  outcome.counts = {{"segments", all.size()}, {"edge and chain pairs", missing.size()}};
  const auto wrong =
      std::find_if(missing.begin(), missing.end(), [](const auto& m) { return m.second != 0; });
  if (wrong != missing.end()) {
    const auto& [edge_of, edge, chain] = wrong->first;
    outcome.fail("edge " + std::to_string(edge.vertex) + " of chain " + std::to_string(edge.chain) +
                 " of " + (edge_of == Summand::P ? "P" : "Q") +
                 " is in the wrong number of tangent sets of chain " + std::to_string(chain) +
                 " of the other summand, off by " + std::to_string(wrong->second));
  }
  return outcome;
}

const Registered fact_convolution_size(larger_mixture(), {.id = "fact-convolution-size",
                                                          .kills = {"acute-vertex-is-reflex",
                                                                    "reflex-turns-clockwise",
                                                                    "tangent-set-without-ties"},
                                                          .cases = 1500,
                                                          .check = check_convolution_size});

}  // namespace

}  // namespace oplus
