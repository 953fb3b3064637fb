// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/statements/chapter4/convolution_graph.hpp"

namespace oplus {

/// An edge of a graph, by its place in the order of `boost::edges`, so that parallel ones differ.
struct NumberedEdge {
  std::size_t number;
  ConvolutionGraph::vertex_descriptor source;
  ConvolutionGraph::vertex_descriptor target;
};

/// Each edge starts where the one before ends; closed if the first starts where the last ends.
using Walk = std::vector<NumberedEdge>;

/// Returns sequences of edges that together are all edges of the graph, each exactly once
/// (Hierholzer's algorithm). Where every node is entered as often as left, they are closed walks,
/// one for each connected part: Euler circuits. Elsewhere one of them is no closed walk.
std::vector<Walk> euler_circuits(const ConvolutionGraph& graph);

/// Cuts a closed walk where it comes back to a node: closed walks that pass no node twice, of the
/// same edges.
std::vector<Walk> simple_cycles(const Walk& closed);

/// What keeps this from being a closed walk, in words, or empty.
std::string defect_of_closed_walk(const Walk& walk);

}  // namespace oplus
