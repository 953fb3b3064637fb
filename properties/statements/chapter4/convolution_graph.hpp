// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/graph/adjacency_list.hpp>
#include <string>
#include <vector>

#include "reference/definitions/convolution.hpp"

namespace oplus {

/// Nodes carry a name for messages; parallel edges stay apart.
using ConvolutionGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS,
                                               boost::property<boost::vertex_name_t, std::string>>;

/// The convolution graph (thesis, Definition 4.1.2): an edge for each segment; ends of segments at
/// the same point are one node.
ConvolutionGraph convolution_graph(const std::vector<ConvolutionSegment>& convolution);

/// The fiber grid (thesis, Definition 4.1.7): the same edges, and a node for each state (i, j),
/// vertex i of P at vertex j of Q.
ConvolutionGraph fiber_grid(const std::vector<ConvolutionSegment>& convolution, const Region& p,
                            const Region& q);

}  // namespace oplus
