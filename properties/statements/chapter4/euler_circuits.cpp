// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/euler_circuits.hpp"

#include <algorithm>
#include <boost/range/iterator_range.hpp>
#include <iterator>
#include <set>

namespace oplus {

namespace {

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

/// Goes on while it can; where it cannot, the last edge is the last of the circuit not yet known.
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

}  // namespace

std::vector<Walk> euler_circuits(const ConvolutionGraph& graph) {
  Untaken untaken(graph);
  std::vector<Walk> circuits;
  for (std::size_t node = 0; node < untaken.nodes(); ++node)
    while (untaken.any_from(node)) circuits.push_back(circuit_from(node, untaken));
  return circuits;
}

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

std::string defect_of_closed_walk(const Walk& walk) {
  if (walk.empty()) return "a walk has no edge";
  for (std::size_t k = 0; k < walk.size(); ++k)
    if (walk[k].target != walk[(k + 1) % walk.size()].source)
      return "edge " + std::to_string(k) + " of " + std::to_string(walk.size()) +
             " does not end where the next one starts";
  return {};
}

}  // namespace oplus
