// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/statement_graph.hpp"

#include <algorithm>
#include <boost/graph/graphviz.hpp>
#include <boost/graph/strong_components.hpp>
#include <map>
#include <sstream>

namespace oplus {

namespace {

std::map<std::string, std::size_t> numbers(const std::vector<Statement>& statements) {
  std::map<std::string, std::size_t> result;
  for (const Statement& s : statements) result.emplace(s.id, result.size());
  return result;
}

std::vector<std::size_t> strong_component_of_each(const StatementGraph& graph) {
  std::vector<std::size_t> component(boost::num_vertices(graph));
  boost::strong_components(graph, boost::make_iterator_property_map(
                                      component.begin(), boost::get(boost::vertex_index, graph)));
  return component;
}

}  // namespace

StatementGraph statement_graph(const std::vector<Statement>& statements) {
  const std::map<std::string, std::size_t> number = numbers(statements);
  StatementGraph graph(statements.size());
  for (std::size_t i = 0; i < statements.size(); ++i)
    for (const std::string& below : statements[i].rests_on)
      if (const auto found = number.find(below); found != number.end())
        boost::add_edge(i, found->second, graph);
  return graph;
}

std::vector<std::string> defects_of_graph(const std::vector<Statement>& statements) {
  std::vector<std::string> defects;
  const std::map<std::string, std::size_t> number = numbers(statements);
  for (const Statement& s : statements) {
    for (const std::string& below : s.rests_on) {
      if (!number.contains(below)) defects.push_back(s.id + ": rests on an unknown " + below);
      if (below == s.id) defects.push_back(s.id + ": rests on itself");
    }
  }
  std::map<std::size_t, std::string> members;
  std::map<std::size_t, std::size_t> sizes;
  const std::vector<std::size_t> component = strong_component_of_each(statement_graph(statements));
  for (std::size_t i = 0; i < component.size(); ++i) {
    std::string& names = members[component[i]];
    names += (names.empty() ? "" : ", ") + statements[i].id;
    ++sizes[component[i]];
  }
  for (const auto& [which, size] : sizes)
    if (size > 1) defects.push_back(members[which] + ": rest on each other");
  return defects;
}

std::string to_dot(const std::vector<Statement>& statements,
                   const std::function<NodeColours(const Statement&)>& colours) {
  std::ostringstream out;
  const auto write_node = [&](std::ostream& node, std::size_t i) {
    const Statement& s = statements[i];
    const NodeColours of_node = colours(s);
    node << "[label=\"" << s.id << "\", URL=\"" << s.id << ".md\", tooltip=\"" << s.title
         << "\", fillcolor=\"" << of_node.fill << "\", color=\"" << of_node.border << "\"]";
  };
  const auto write_edge = [](std::ostream&, const StatementGraph::edge_descriptor&) {};
  // A fixed width, so that the drawing does not depend on the installed fonts.
  const auto write_graph = [](std::ostream& graph) {
    graph << "rankdir=LR; ranksep=0.35; nodesep=0.12;\n"
             "node [shape=box, style=\"filled,rounded\", fontname=\"sans-serif\", fontsize=10, "
             "fixedsize=true, width=1.7, height=0.28, penwidth=2];\n"
             "edge [color=\"#8898aa\", arrowsize=0.6];\n";
  };
  boost::write_graphviz(out, statement_graph(statements), write_node, write_edge, write_graph);
  return out.str();
}

}  // namespace oplus
