// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/origins_json.hpp"

#include "checked/cli/json_values.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// The kind of each edge, in the order of `edges(sum)`.
std::vector<std::string> kinds(const PlanarSet& sum) {
  std::vector<std::string> result;
  for (const Chain& chain : sum.outer) result.insert(result.end(), chain.size(), "outer");
  for (const Chain& hole : sum.holes) result.insert(result.end(), hole.size(), "hole");
  result.insert(result.end(), sum.dangling_edges.size(), "dangling");
  return result;
}

/// Names the chains of both summands by number.
class Naming {
 public:
  Naming(const Region& p, const Region& q) : p_(chains(p)), q_(chains(q)) {}

  Json json(const Origin& origin) const {
    const Chain& with_edge = of(origin.edge_of).at(origin.edge.chain);
    const Chain& with_vertex = of(other(origin.edge_of)).at(origin.vertex.chain);
    const std::size_t i = origin.edge.vertex;
    return {{"edge",
             {{"of", name(origin.edge_of)},
              {"chain", origin.edge.chain},
              {"leaves", i},
              {"from", oplus::json(with_edge.at(i))},
              {"to", oplus::json(with_edge.at(next(i, with_edge.size())))}}},
            {"vertex",
             {{"of", name(other(origin.edge_of))},
              {"chain", origin.vertex.chain},
              {"index", origin.vertex.vertex},
              {"at", oplus::json(with_vertex.at(origin.vertex.vertex))}}}};
  }

 private:
  static const char* name(Summand s) { return s == Summand::P ? "P" : "Q"; }
  const std::vector<Chain>& of(Summand s) const { return s == Summand::P ? p_ : q_; }

  std::vector<Chain> p_;
  std::vector<Chain> q_;
};

}  // namespace

std::string origins_json(const PlanarSet& sum, const Origins& origins, const Region& p,
                         const Region& q) {
  const std::vector<Segment> of_sum = edges(sum);
  const std::vector<std::string> kind = kinds(sum);
  OPLUS_REQUIRES(origins.size() == of_sum.size(), "an origin for each edge");
  const Naming naming(p, q);
  std::string lines;
  for (std::size_t i = 0; i < of_sum.size(); ++i) {
    Json edge = {{"kind", kind[i]},
                 {"from", json(of_sum[i].source)},
                 {"to", json(of_sum[i].target)},
                 {"origins", Json::array()}};
    for (const Origin& origin : origins.at(i)) edge["origins"].push_back(naming.json(origin));
    lines += (lines.empty() ? "" : ",\n") + edge.dump();
  }
  return "[" + lines + "]\n";
}

}  // namespace oplus
