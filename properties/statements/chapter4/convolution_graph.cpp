// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/convolution_graph.hpp"

#include <map>
#include <utility>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

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

}  // namespace

ConvolutionGraph convolution_graph(const std::vector<ConvolutionSegment>& convolution) {
  GraphOf<Point> graph;
  for (const ConvolutionSegment& s : convolution)
    graph.add_edge(s.segment.source, s.segment.target);
  return graph.take();
}

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

}  // namespace oplus
