// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <boost/range/iterator_range.hpp>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "properties/runner/registry.hpp"
#include "properties/statements/directions_around.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/tangent_set.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Nodes carry a name for messages; parallel edges stay apart.
using ConvolutionGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS,
                                               boost::property<boost::vertex_name_t, std::string>>;

using State = std::pair<VertexIndex, VertexIndex>;

std::string name_of(const Point& p) { return to_string(p); }

std::string name_of(const VertexIndex& v) {
  return "vertex " + std::to_string(v.vertex) + " of chain " + std::to_string(v.chain);
}

std::string name_of(const State& state) {
  return "(" + name_of(state.first) + " of P, " + name_of(state.second) + " of Q)";
}

/// A graph that adds a node when it is first named.
template <typename Key>
class GraphOf {
 public:
  void add_edge(const Key& source, const Key& target) {
    boost::add_edge(node(source), node(target), graph_);
  }
  ConvolutionGraph take() { return std::move(graph_); }

 private:
  ConvolutionGraph::vertex_descriptor node(const Key& key) {
    const auto [known, is_new] = nodes_.try_emplace(key, nodes_.size());
    if (is_new) boost::add_vertex(name_of(key), graph_);
    return known->second;
  }

  std::map<Key, ConvolutionGraph::vertex_descriptor> nodes_;
  ConvolutionGraph graph_;
};

VertexIndex following(const VertexIndex& v, const std::vector<Chain>& all) {
  return {v.chain, next(v.vertex, all[v.chain].size())};
}

/// The convolution graph (thesis, Definition 4.1.2): an edge for each segment; ends of segments at
/// the same point are one node.
ConvolutionGraph convolution_graph(const std::vector<ConvolutionSegment>& convolution) {
  GraphOf<Point> graph;
  for (const ConvolutionSegment& s : convolution)
    graph.add_edge(s.segment.source, s.segment.target);
  return graph.take();
}

/// The fiber grid (thesis, Definition 4.1.7): the same edges, and a node for each state (i, j),
/// vertex i of P at vertex j of Q.
ConvolutionGraph fiber_grid(const std::vector<ConvolutionSegment>& convolution, const Region& p,
                            const Region& q) {
  const std::vector<Chain> of_p = chains(p), of_q = chains(q);
  GraphOf<State> grid;
  for (const auto& [segment, origin, corner] : convolution) {
    const auto& [edge_of, edge, vertex] = origin;
    if (edge_of == Summand::P)
      grid.add_edge({edge, vertex}, {following(edge, of_p), vertex});
    else
      grid.add_edge({vertex, edge}, {vertex, following(edge, of_q)});
  }
  return grid.take();
}

/// Which node has unequal degrees, in words, or empty.
std::string unbalanced_node(const ConvolutionGraph& graph) {
  for (const auto node : boost::make_iterator_range(boost::vertices(graph))) {
    const auto in = boost::in_degree(node, graph), out = boost::out_degree(node, graph);
    if (in != out)
      return boost::get(boost::vertex_name, graph, node) + " has in-degree " + std::to_string(in) +
             " and out-degree " + std::to_string(out);
  }
  return {};
}

Outcome check_in_out_degree(const Summands& summands) {
  const std::vector<ConvolutionSegment> all = convolution(summands.p, summands.q);
  const ConvolutionGraph graph = convolution_graph(all);
  const ConvolutionGraph grid = fiber_grid(all, summands.p, summands.q);
  Outcome outcome;
  outcome.counts = {{"segments", all.size()},
                    {"nodes of the convolution graph", boost::num_vertices(graph)},
                    {"states", boost::num_vertices(grid)}};
  for (const ConvolutionGraph* g : {&grid, &graph}) {
    if (outcome.kind == Outcome::Kind::fails) break;
    outcome.why = unbalanced_node(*g);
    if (!outcome.why.empty()) outcome.kind = Outcome::Kind::fails;
  }
  return outcome;
}

const Registered lemma_4_1_4(larger_mixture(),
                             {.id = "lemma-4.1.4",
                              .kills = {"tangent-set-without-ties", "tie-rule-depends-on-who-asks",
                                        "reflex-turns-clockwise"},
                              .cases = 1500,
                              .check = check_in_out_degree});

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

Outcome check_edge_disjoint_cycles(const Summands& summands) {
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

const Registered lemma_4_1_5(larger_mixture(),
                             {.id = "lemma-4.1.5",
                              .kills = {"tangent-set-without-ties", "tie-rule-depends-on-who-asks",
                                        "reflex-turns-clockwise"},
                              .cases = 1000,
                              .check = check_edge_disjoint_cycles});

/// A row of the fiber grid: a chain of P at a vertex of Q; then `of` is Q. Or a column; then `of`
/// is P.
struct Line {
  Summand of;
  VertexIndex at;
  std::size_t along;  ///< a chain of the other summand

  friend auto operator<=>(const Line&, const Line&) = default;
};

/// How often a vertex that turns by less than π, left or right, passes d: 1, 0 or -1.
int passed(std::size_t d, std::size_t in, std::size_t out, const DirectionsAround& around) {
  const std::size_t half = around.places() / 2, turn = around.turn(in, out);
  if (turn < half) return around.turn(in, d) < turn ? 1 : 0;
  return around.turn(out, d) < around.places() - turn ? -1 : 0;
}

Enumeration enumerate() {
  const DirectionsAround directions(4);
  Enumeration result;
  for (const Summand edge_of : {Summand::P, Summand::Q}) {
    const Summand of = other(edge_of);
    for_each_choice<3>(directions.size(), [&](const std::array<std::size_t, 3>& choice) {
      const auto [in, out, d] = choice;
      if (out == directions.opposite(in)) return;  // it turns back, as no vertex of a region does
      const Corner corner{directions[in], directions[out]};
      const int times = in_tangent_set({directions[d], edge_of}, corner) ? 1 : 0;
      const int reflex = is_reflex(corner) ? 1 : 0;
      const int expected = passed(directions.place(d, edge_of), directions.place(in, of),
                                  directions.place(out, of), directions) +
                           reflex;
      ++result.cases;
      if (!result.failure.empty() || times == expected) return;
      result.failure = "at a vertex with edges " + to_string(corner.in) + " and " +
                       to_string(corner.out) + " the other summand's direction " +
                       to_string(directions[d]) + " is in the tangent set " +
                       std::to_string(times) + " times, and should be " + std::to_string(expected);
    });
  }
  return result;
}

/// All rows, or all columns.
void add_lines(Summand of, const Region& region, const Region& across,
               std::map<Line, std::size_t>& lines) {
  const std::vector<Chain> own = chains(region), others = chains(across);
  for (std::size_t chain = 0; chain < own.size(); ++chain)
    for (std::size_t vertex = 0; vertex < own[chain].size(); ++vertex)
      for (std::size_t along = 0; along < others.size(); ++along)
        lines[{of, {chain, vertex}, along}] = 0;
}

Outcome check_rows_and_columns(const Summands& summands) {
  std::map<Line, std::size_t> leaving;
  add_lines(Summand::P, summands.p, summands.q, leaving);
  add_lines(Summand::Q, summands.q, summands.p, leaving);
  for (const ConvolutionSegment& s : convolution(summands.p, summands.q))
    ++leaving[{s.origin.edge_of, s.origin.edge, s.origin.vertex.chain}];
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  Outcome outcome;
  for (const auto& [line, edges] : leaving) {
    const Chain& along = (line.of == Summand::P ? of_q : of_p)[line.along];
    const bool is_hole = sign(twice_area(along)) < 0;
    ++outcome.counts[is_hole ? "rows and columns along holes" : "along outer chains"];
    if (edges >= (is_hole ? 2U : 1U)) continue;
    outcome.fail("too few edges, " + std::to_string(edges) + ", leave the line of vertex " +
                 std::to_string(line.at.vertex) + " of chain " + std::to_string(line.at.chain) +
                 " of " + (line.of == Summand::P ? "P" : "Q") + " along chain " +
                 std::to_string(line.along) + " of the other summand");
    break;
  }
  return outcome;
}

const Registered lemma_4_1_8(larger_mixture(),
                             {.id = "lemma-4.1.8",
                              .kills = {"acute-vertex-is-reflex", "angles-grow-clockwise",
                                        "between-is-on-the-other-arc", "reflex-turns-clockwise",
                                        "tangent-set-without-ties", "ties-go-the-other-way"},
                              .cases = 1000,
                              .check = check_rows_and_columns,
                              .enumerate = enumerate});

}  // namespace

}  // namespace oplus
