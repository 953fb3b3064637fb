// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "properties/runner/registry.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus {

namespace {

/// How many tangent sets of a chain contain a direction: the same for every direction. An outer
/// chain turns by 2π, a hole by -2π; a reflex vertex turns clockwise by less than π, but its
/// tangent set is the rest of the circle, counterclockwise: one full turn more.
std::ptrdiff_t times_covered(const Chain& chain) {
  std::ptrdiff_t reflex = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) reflex += is_reflex(corner_at(chain, i)) ? 1 : 0;
  return sign(twice_area(chain)) + reflex;
}

/// The segments made of one edge and the vertices of one chain.
using Group = std::tuple<Summand, VertexIndex, std::size_t>;

void expect(Summand edge_of, const Region& with_edges, const Region& with_vertices,
            std::map<Group, std::ptrdiff_t>& missing) {
  const std::vector<Chain> of_edges = chains(with_edges), of_vertices = chains(with_vertices);
  for (std::size_t a = 0; a < of_edges.size(); ++a)
    for (std::size_t i = 0; i < of_edges[a].size(); ++i)
      for (std::size_t b = 0; b < of_vertices.size(); ++b)
        missing[{edge_of, {a, i}, b}] = times_covered(of_vertices[b]);
}

Outcome check(const Summands& summands) {
  std::map<Group, std::ptrdiff_t> missing;
  expect(Summand::P, summands.p, summands.q, missing);
  expect(Summand::Q, summands.q, summands.p, missing);
  const std::vector<ConvolutionSegment> all = convolution(summands.p, summands.q);
  for (const ConvolutionSegment& s : all)
    --missing[{s.origin.edge_of, s.origin.edge, s.origin.vertex.chain}];
  Outcome outcome;
  outcome.counts = {{"segments", all.size()}, {"edge and chain pairs", missing.size()}};
  const auto wrong =
      std::find_if(missing.begin(), missing.end(), [](const auto& m) { return m.second != 0; });
  if (wrong != missing.end()) {
    const auto& [edge_of, edge, chain] = wrong->first;
    outcome.fail("edge " + std::to_string(edge.vertex) + " of chain " + std::to_string(edge.chain) +
                 " of " + (edge_of == Summand::P ? "P" : "Q") +
                 " is in the wrong number of tangent sets of chain " + std::to_string(chain) +
                 " of the other summand, off by " + std::to_string(wrong->second));
  }
  return outcome;
}

const Registered registered(larger_mixture(),
                            {.id = "fact-convolution-size",
                             .kills = {"acute-vertex-is-reflex", "reflex-turns-clockwise",
                                       "tangent-set-without-ties"},
                             .cases = 1500,
                             .check = check});

}  // namespace

}  // namespace oplus
