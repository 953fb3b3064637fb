// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/graph/strong_components.hpp>
#include <set>

#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/euler_circuits.hpp"

namespace oplus {

namespace {

std::size_t strong_components(const ConvolutionGraph& graph) {
  std::vector<std::size_t> component(boost::num_vertices(graph));
  return boost::strong_components(
      graph,
      boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, graph)));
}

/// Whether no edge starts where another does.
bool is_simple(const Walk& cycle) {
  std::set<std::size_t> nodes;
  for (const NumberedEdge& edge : cycle)
    if (!nodes.insert(edge.source).second) return false;
  return true;
}

/// What is wrong with the cycles as a decomposition of so many edges, or empty.
std::string defect_of_decomposition(const std::vector<Walk>& cycles, std::size_t edges) {
  std::set<std::size_t> taken;
  for (const Walk& cycle : cycles) {
    const std::string defect = defect_of_closed_walk(cycle);
    if (!defect.empty()) return defect;
    for (const NumberedEdge& edge : cycle)
      if (!taken.insert(edge.number).second) return "an edge is in two cycles, or twice in one";
  }
  return taken.size() == edges ? "" : "an edge is in no cycle";
}

std::string defect_of(const ConvolutionGraph& graph, Outcome& outcome) {
  const std::size_t edges = boost::num_edges(graph);
  const std::vector<Walk> circuits = euler_circuits(graph);
  std::string defect = defect_of_decomposition(circuits, edges);
  if (!defect.empty()) return "circuits: " + defect;
  // Two circuits in one part would be two parts that edges join one way only, or a part cut in two.
  if (circuits.size() != strong_components(graph)) return "a connected part has no Euler circuit";
  std::vector<Walk> cycles;
  for (const Walk& circuit : circuits)
    for (Walk& cycle : simple_cycles(circuit)) cycles.push_back(std::move(cycle));
  defect = defect_of_decomposition(cycles, edges);
  if (!defect.empty()) return "cycles: " + defect;
  for (const Walk& cycle : cycles)
    if (!is_simple(cycle)) return "cycles: one passes a node twice";
  outcome.counts["edges"] += edges;
  outcome.counts["Euler circuits"] += circuits.size();
  outcome.counts["cycles that pass no node twice"] += cycles.size();
  return {};
}

Outcome check(const Summands& summands) {
  const std::vector<ConvolutionSegment> all = convolution(summands.p, summands.q);
  Outcome outcome;
  outcome.why = defect_of(convolution_graph(all), outcome);
  if (outcome.why.empty()) {
    outcome.why = defect_of(fiber_grid(all, summands.p, summands.q), outcome);
    if (!outcome.why.empty()) outcome.why = "in the fiber grid, " + outcome.why;
  }
  if (!outcome.why.empty()) outcome.kind = Outcome::Kind::fails;
  return outcome;
}

const Registered registered({
    .id = "lemma-4.1.5",
    .kind = "lemma",
    .title = "The convolution graph decomposes into edge-disjoint cycles",
    .statement =
        "The edges of the convolution graph are those of directed cycles that share no edge, each "
        "of which passes no node twice; and each connected part of the graph has an Euler circuit, "
        "so it is strongly connected. The same holds for the fiber grid.",
    .why =
        "Every node is entered as often as it is left (Lemma 4.1.4), so by Euler's theorem each "
        "connected part has a circuit. Cut where it comes back to a node, it falls into cycles. "
        "Here circuits are found by Hierholzer's algorithm, which knows nothing of states or of "
        "Algorithm 2, and what it finds is checked edge by edge; that there is one for each strong "
        "component, by Boost's count of these.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed",
                   "one tie rule for both kinds of segments"},
    .rests_on = {"lemma-4.1.4"},
    .sources = larger_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"tangent-set-without-ties", "tie-rule-depends-on-who-asks", "reflex-turns-clockwise"},
    .cases = 1000,
    .check = check,
});

}  // namespace

}  // namespace oplus
