// SPDX-License-Identifier: MIT
#include "reference/definitions/convolution.hpp"

#include <deque>
#include <iterator>

#include "reference/definitions/mutant.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus {

namespace {

std::vector<Corner> corners(const Chain& chain) {
  std::vector<Corner> result;
  for (std::size_t j = 0; j < chain.size(); ++j) result.push_back(corner_at(chain, j));
  return result;
}

/// Adds the sums of one summand's edges and the other's vertices for which `is_kept(direction of
/// the edge, corner at the vertex)`.
template <typename IsKept>
void add_sums(const Region& with_edges, const Region& with_vertices, Summand edge_of,
              IsKept is_kept, std::deque<ConvolutionSegment>& sums) {
  const std::vector<Chain> edge_chains = chains(with_edges);
  const std::vector<Chain> vertex_chains = chains(with_vertices);
  for (std::size_t a = 0; a < edge_chains.size(); ++a) {
    const std::vector<Segment> chain_edges = edges(edge_chains[a]);
    for (std::size_t b = 0; b < vertex_chains.size(); ++b) {
      const Chain& vertices = vertex_chains[b];
      const std::vector<Corner> chain_corners = corners(vertices);
      for (std::size_t i = 0; i < chain_edges.size(); ++i) {
        const Direction direction{direction_of(chain_edges[i]), edge_of};
        for (std::size_t j = 0; j < vertices.size(); ++j) {
          if (!is_kept(direction, chain_corners[j])) continue;
          const std::size_t named =
              OPLUS_MUTANT("sums-name-the-vertex-before",
                           "the sum of an edge and a vertex names the vertex before as its origin")
                  ? previous(j, vertices.size())
                  : j;
          sums.push_back(
              {{chain_edges[i].source + vertices[j], chain_edges[i].target + vertices[j]},
               {edge_of, {a, i}, {b, named}},
               is_reflex(chain_corners[j])});
        }
      }
    }
  }
}

template <typename IsKept>
std::vector<ConvolutionSegment> kept_sums(const Region& p, const Region& q, IsKept is_kept) {
  std::deque<ConvolutionSegment> sums;  // grows without copying
  add_sums(p, q, Summand::P, is_kept, sums);
  add_sums(q, p, Summand::Q, is_kept, sums);
  return {std::make_move_iterator(sums.begin()), std::make_move_iterator(sums.end())};
}

bool in_convolution(const Direction& direction, const Corner& corner) {
  if (OPLUS_MUTANT(
          "tie-rule-depends-on-who-asks",
          "whichever summand has the edge, its direction comes before an equal one of the vertex"))
    return in_tangent_set({direction.vector, Summand::P}, corner);
  return in_tangent_set(direction, corner);
}

}  // namespace

std::vector<ConvolutionSegment> vertex_edge_sum(const Region& p, const Region& q) {
  return kept_sums(p, q, [](const Direction& d, const Corner&) {
    return !(OPLUS_MUTANT("vertices-of-p-are-left-out",
                          "the vertex-edge sum has the edges of P at the vertices of Q only") &&
             d.of == Summand::Q);
  });
}

std::vector<ConvolutionSegment> convolution(const Region& p, const Region& q) {
  return kept_sums(p, q, in_convolution);
}

std::vector<ConvolutionSegment> reduced_convolution(const Region& p, const Region& q) {
  return kept_sums(p, q, [](const Direction& direction, const Corner& corner) {
    return in_convolution(direction, corner) && !is_reflex(corner);
  });
}

std::vector<Segment> segments(const std::vector<ConvolutionSegment>& convolution) {
  std::vector<Segment> result;
  result.reserve(convolution.size());
  for (const ConvolutionSegment& s : convolution) result.push_back(s.segment);
  return result;
}

}  // namespace oplus
