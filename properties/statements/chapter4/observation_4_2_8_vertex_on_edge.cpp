// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "properties/runner/registry.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr std::size_t most_segments = 60;  // per pair

bool lies_inside(const Point& p, const Segment& s) {
  return p != s.source && p != s.target && lies_on(p, s);
}

const Point& vertex_of(const std::vector<Chain>& all, const VertexIndex& v) {
  return all[v.chain][v.vertex];
}

Segment edge_of(const std::vector<Chain>& all, const VertexIndex& e) {
  const Chain& chain = all[e.chain];
  return {chain[e.vertex], chain[next(e.vertex, chain.size())]};
}

/// Whether the vertex that the origin names is inside the edge that it names, in P and -Q+x, whose
/// chains are in the order of Q's.
bool meet_as_named(const Origin& origin, const std::vector<Chain>& of_p,
                   const std::vector<Chain>& placed) {
  return origin.edge_of == Summand::P
             ? lies_inside(vertex_of(placed, origin.vertex), edge_of(of_p, origin.edge))
             : lies_inside(vertex_of(of_p, origin.vertex), edge_of(placed, origin.edge));
}

/// The number of pairs of a vertex of one region and an edge of the other with the vertex inside
/// the edge.
std::size_t vertices_inside_edges(const Region& vertices_of, const Region& edges_of) {
  std::size_t count = 0;
  for (const Segment& e : edges(edges_of))
    for (const Chain& chain : chains(vertices_of))
      count += static_cast<std::size_t>(std::count_if(
          chain.begin(), chain.end(), [&](const Point& v) { return lies_inside(v, e); }));
  return count;
}

Outcome check(const Summands& summands) {
  const auto& [p, q] = summands;
  const std::vector<Chain> of_p = chains(p);
  const std::vector<ConvolutionSegment> all = convolution(p, q), sums = vertex_edge_sum(p, q);
  const Region turned = reflected(q);
  const std::size_t looked_at = std::min(all.size(), most_segments);
  Outcome outcome;
  for (std::size_t k = 0; k < looked_at; ++k) {
    const auto& [segment, origin, corner] = all[k * all.size() / looked_at];
    for (const Rational& t : {Rational(1, 2), Rational(13, 31)}) {
      const Point x = segment.source + t * direction_of(segment);
      const Region placed = translated(turned, x);
      const std::size_t met = vertices_inside_edges(p, placed) + vertices_inside_edges(placed, p);
      const auto through = static_cast<std::size_t>(std::count_if(
          sums.begin(), sums.end(), [&](const auto& s) { return lies_inside(x, s.segment); }));
      ++outcome.counts["points"];
      outcome.counts["vertices inside edges"] += met;
      if (!meet_as_named(origin, of_p, chains(placed)))
        outcome.why = "the named vertex is not inside the named edge";
      else if (met != through)
        outcome.why =
            "vertices inside edges: " + std::to_string(met) +
            ", segments of the vertex-edge sum with the point inside: " + std::to_string(through);
      if (outcome.why.empty()) continue;
      return outcome.fail("at " + to_string(x) + " " + outcome.why, x);
    }
  }
  return outcome;
}

const Registered registered(small_mixture(), {.id = "observation-4.2.8",
                                              .kills = {"sums-name-the-vertex-before"},
                                              .cases = 100,
                                              .check = check});

}  // namespace

}  // namespace oplus
