// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "properties/runner/mixture.hpp"
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

const Registered registered({
    .id = "fact-convolution-size",
    .title = "The number of segments of the convolution",
    .statement =
        "|P ⊗ Q| = n_P (χ_Q + r_Q) + n_Q (χ_P + r_P), where n is the number of vertices, r the "
        "number of reflex ones (of a hole, those where it turns right), and χ the number of outer "
        "chains minus the number of holes. For simple polygons χ = 1. More exactly, each edge is "
        "in s + r tangent sets of each chain of the other summand, s = 1 for an outer chain and "
        "-1 for a hole; that is what is tested.",
    .why =
        "The turns of a chain add up to 2π s, so each direction is passed s times, counting "
        "clockwise passes as -1. A convex vertex passes the directions of its tangent set "
        "counterclockwise. A reflex vertex passes the directions outside its tangent set "
        "clockwise: it counts 0 for a direction in its tangent set and -1 for any other, so 1 "
        "less than whether the direction is in it (1 or 0). So each direction is in s + r tangent "
        "sets. Ties do not matter, since the tie rule turns all of Q's directions together; a "
        "vertex inside a straight line does not turn, and its tangent set is empty.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed"},
    .rests_on = {},
    .sources = larger_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"acute-vertex-is-reflex", "reflex-turns-clockwise", "tangent-set-without-ties"},
    .cases = 1500,
    .check = check,
});

}  // namespace

}  // namespace oplus
