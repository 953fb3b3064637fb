// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/range/iterator_range.hpp>

#include "properties/runner/mixture.hpp"
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

const Registered registered({
    .id = "lemma-4.1.4",
    .title = "In-degree equals out-degree in the convolution graph",
    .statement =
        "At each node of the convolution graph as many segments end as start. The same holds at "
        "each state, a vertex of P at a vertex of Q, before states at the same point become one "
        "node.",
    .why =
        "At a state, the directions of the four edges lie on a circle, ties decided by the tie "
        "rule. The edge that enters a vertex and the edge that leaves it bound its tangent set; "
        "however the four interleave on the circle, as many entering as leaving directions are in "
        "the other vertex's tangent set. A node is a set of states, and their degrees add up.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed",
                   "one tie rule for both kinds of segments"},
    .rests_on = {"lemma-4.1.3"},
    .sources = larger_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"tangent-set-without-ties", "tie-rule-depends-on-who-asks", "reflex-turns-clockwise"},
    .cases = 1500,
    .check = check,
});

}  // namespace

}  // namespace oplus
