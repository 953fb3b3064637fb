// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/graph/adjacency_list.hpp>
#include <functional>
#include <string>
#include <vector>

#include "properties/runner/statement.hpp"

namespace oplus {

/// Which statement rests on which: node i is statement i, an edge leads from a statement to one that
/// it rests on.
using StatementGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS>;

/// Edges to unknown statements are left out; defects_of_graph reports them.
StatementGraph statement_graph(const std::vector<Statement>& statements);

/// What is wrong with it, a line each: a statement that rests on an unknown one or on itself, a cycle.
std::vector<std::string> defects_of_graph(const std::vector<Statement>& statements);

struct NodeColours {
  std::string fill, border;
};

/// Returns the graph for Graphviz; each node has its colours and a link to its page.
std::string to_dot(const std::vector<Statement>& statements,
                   const std::function<NodeColours(const Statement&)>& colours);

}  // namespace oplus
