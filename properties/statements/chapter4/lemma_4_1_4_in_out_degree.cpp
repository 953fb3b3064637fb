// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/range/iterator_range.hpp>

#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/convolution_graph.hpp"

namespace oplus {

namespace {

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

Outcome check(const Summands& summands) {
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

const Registered registered(larger_mixture(),
                            {.id = "lemma-4.1.4",
                             .kills = {"tangent-set-without-ties", "tie-rule-depends-on-who-asks",
                                       "reflex-turns-clockwise"},
                             .cases = 1500,
                             .check = check});

}  // namespace

}  // namespace oplus
