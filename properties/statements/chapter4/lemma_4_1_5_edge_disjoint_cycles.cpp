// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/graph/strong_components.hpp>
#include <boost/range/iterator_range.hpp>
#include <iterator>
#include <set>

#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/convolution_graph.hpp"

namespace oplus {

namespace {

/// An edge of a graph, by its place in the order of `boost::edges`, so that parallel ones differ.
struct NumberedEdge {
  std::size_t number;
  ConvolutionGraph::vertex_descriptor source;
  ConvolutionGraph::vertex_descriptor target;
};

/// Each edge starts where the one before ends; closed if the first starts where the last ends.
using Walk = std::vector<NumberedEdge>;

/// The edges that leave each node and have not been taken.
class Untaken {
 public:
  explicit Untaken(const ConvolutionGraph& graph) : leaving_(boost::num_vertices(graph)) {
    std::size_t number = 0;
    for (const auto edge : boost::make_iterator_range(boost::edges(graph))) {
      const auto source = boost::source(edge, graph);
      leaving_[source].push_back({number++, source, boost::target(edge, graph)});
    }
  }
  std::size_t nodes() const { return leaving_.size(); }
  bool any_from(std::size_t node) const { return !leaving_[node].empty(); }
  NumberedEdge take_from(std::size_t node) {
    const NumberedEdge edge = leaving_[node].back();
    leaving_[node].pop_back();
    return edge;
  }

 private:
  std::vector<Walk> leaving_;
};

/// Goes on as long as possible; where that ends, the last edge of the path is the next one of the
/// circuit, from its end.
Walk circuit_from(std::size_t start, Untaken& untaken) {
  Walk path = {untaken.take_from(start)}, circuit;
  while (!path.empty()) {
    if (const std::size_t end = path.back().target; untaken.any_from(end)) {
      path.push_back(untaken.take_from(end));
    } else {
      circuit.push_back(path.back());
      path.pop_back();
    }
  }
  std::reverse(circuit.begin(), circuit.end());
  return circuit;
}

/// Returns sequences of edges that together are all edges of the graph, each exactly once
/// (Hierholzer's algorithm). Where every node is entered as often as left, they are closed walks,
/// one for each connected part: Euler circuits. Elsewhere one of them is no closed walk.
std::vector<Walk> euler_circuits(const ConvolutionGraph& graph) {
  Untaken untaken(graph);
  std::vector<Walk> circuits;
  for (std::size_t node = 0; node < untaken.nodes(); ++node)
    while (untaken.any_from(node)) circuits.push_back(circuit_from(node, untaken));
  return circuits;
}

/// Cuts a closed walk where it comes back to a node: closed walks that pass no node twice, of the
/// same edges.
std::vector<Walk> simple_cycles(const Walk& closed) {
  std::vector<Walk> cycles;
  Walk path;
  std::set<std::size_t> on_path;  // where its edges start
  for (const NumberedEdge& edge : closed) {
    path.push_back(edge);
    on_path.insert(edge.source);
    if (!on_path.count(edge.target)) continue;
    const auto first = std::find_if(path.begin(), path.end(),
                                    [&](const NumberedEdge& e) { return e.source == edge.target; });
    for (auto it = first; it != path.end(); ++it) on_path.erase(it->source);
    cycles.emplace_back(first, path.end());
    path.erase(first, path.end());
  }
  return cycles;
}

/// What keeps this from being a closed walk, in words, or empty.
std::string defect_of_closed_walk(const Walk& walk) {
  if (walk.empty()) return "a walk has no edge";
  for (std::size_t k = 0; k < walk.size(); ++k)
    if (walk[k].target != walk[(k + 1) % walk.size()].source)
      return "edge " + std::to_string(k) + " of " + std::to_string(walk.size()) +
             " does not end where the next one starts";
  return {};
}

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

/// What is wrong with the cycles as a decomposition of this number of edges, or empty.
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
  // Two circuits in one connected part would mean that it is not strongly connected, or cut in two.
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

const Registered registered(larger_mixture(),
                            {.id = "lemma-4.1.5",
                             .kills = {"tangent-set-without-ties", "tie-rule-depends-on-who-asks",
                                       "reflex-turns-clockwise"},
                             .cases = 1000,
                             .check = check});

}  // namespace

}  // namespace oplus
