// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/convolution.hpp"

#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

void add_sums(const Region& with_edges, const Region& with_vertices, Summand edge_of,
              std::vector<ConvolutionSegment>& sums) {
  const std::vector<Chain> edge_chains = chains(with_edges);
  const std::vector<Chain> vertex_chains = chains(with_vertices);
  for (std::size_t a = 0; a < edge_chains.size(); ++a) {
    const std::vector<Segment> chain_edges = edges(edge_chains[a]);
    for (std::size_t b = 0; b < vertex_chains.size(); ++b) {
      const Chain& vertices = vertex_chains[b];
      for (std::size_t i = 0; i < chain_edges.size(); ++i) {
        for (std::size_t j = 0; j < vertices.size(); ++j) {
          const Point& v = vertices[j];
          const Corner corner{v - vertices[previous(j, vertices.size())],
                              vertices[next(j, vertices.size())] - v};
          sums.push_back({{chain_edges[i].source + v, chain_edges[i].target + v},
                          {edge_of, {a, i}, {b, j}},
                          corner});
        }
      }
    }
  }
}

bool in_convolution(const ConvolutionSegment& s) {
  const Summand of = OPLUS_MUTANT("tie-rule-depends-on-who-asks") ? Summand::P : s.origin.edge_of;
  return in_tangent_set({direction_of(s.segment), of}, s.corner);
}

}  // namespace

std::vector<ConvolutionSegment> vertex_edge_sum(const Region& p, const Region& q) {
  std::vector<ConvolutionSegment> sums;
  sums.reserve(2 * vertex_count(p) * vertex_count(q));
  add_sums(p, q, Summand::P, sums);
  add_sums(q, p, Summand::Q, sums);
  return sums;
}

std::vector<ConvolutionSegment> convolution(const Region& p, const Region& q) {
  std::vector<ConvolutionSegment> result = vertex_edge_sum(p, q);
  std::erase_if(result, [](const ConvolutionSegment& s) { return !in_convolution(s); });
  return result;
}

std::vector<ConvolutionSegment> reduced_convolution(const Region& p, const Region& q) {
  std::vector<ConvolutionSegment> result = convolution(p, q);
  std::erase_if(result, [](const ConvolutionSegment& s) { return is_reflex(s.corner); });
  return result;
}

std::vector<Segment> segments(const std::vector<ConvolutionSegment>& convolution) {
  std::vector<Segment> result;
  result.reserve(convolution.size());
  for (const ConvolutionSegment& s : convolution) result.push_back(s.segment);
  return result;
}

}  // namespace oplus
