// SPDX-License-Identifier: MIT
#include "reference/definitions/original_convolution.hpp"

#include "reference/definitions/mutant.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus {

namespace {

void add_reflex_vertices(const Region& region, Summand of, std::vector<ReflexVertex>& all) {
  const std::vector<Chain> of_region = chains(region);
  for (std::size_t c = 0; c < of_region.size(); ++c) {
    const Chain& chain = of_region[c];
    for (std::size_t i = 0; i < chain.size(); ++i)
      if (is_reflex(corner_at(chain, i))) all.push_back({of, {c, i}});
  }
}

ConvolutionSegment flipped(ConvolutionSegment s) {
  if (!OPLUS_MUTANT("flip-set-keeps-its-direction",
                    "the segments that replace those of a reflex vertex run along their edges"))
    s.segment = reversed(s.segment);
  return s;
}

/// Of each segment of 𝒮 what is there after the replacement at the vertices that are meant.
template <typename IsReplaced>
std::vector<ConvolutionSegment> replaced(const Region& p, const Region& q, IsReplaced is_replaced) {
  const std::vector<ConvolutionSegment> kept = convolution(p, q);
  auto next_kept = kept.begin();  // 𝒞 is in the order of 𝒮
  std::vector<ConvolutionSegment> result;
  for (const ConvolutionSegment& s : vertex_edge_sum(p, q)) {
    const bool in_convolution = next_kept != kept.end() && next_kept->origin == s.origin;
    if (in_convolution) ++next_kept;
    const bool is_flipped = s.vertex_is_reflex && is_replaced(s.origin);
    if (in_convolution == is_flipped) continue;
    result.push_back(is_flipped ? flipped(s) : s);
  }
  return result;
}

}  // namespace

std::vector<ReflexVertex> reflex_vertices(const Region& p, const Region& q) {
  std::vector<ReflexVertex> all;
  add_reflex_vertices(p, Summand::P, all);
  add_reflex_vertices(q, Summand::Q, all);
  return all;
}

std::vector<ConvolutionSegment> replaced_at(const ReflexVertex& vertex, const Region& p,
                                            const Region& q) {
  return replaced(p, q, [&](const Origin& origin) {
    return origin.edge_of == other(vertex.of) && origin.vertex == vertex.vertex;
  });
}

std::vector<ConvolutionSegment> original_convolution(const Region& p, const Region& q) {
  return replaced(p, q, [](const Origin& origin) {
    return !OPLUS_MUTANT("reflex-vertices-of-q-are-not-replaced",
                         "flip sets are taken at the reflex vertices of P only") ||
           origin.edge_of == Summand::Q;
  });
}

}  // namespace oplus
