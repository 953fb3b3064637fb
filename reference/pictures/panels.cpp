// SPDX-License-Identifier: MIT
#include "reference/chains/region_of.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/io/counted.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

Panel panel_of(Summand which, const Region& summand) {
  const bool is_p = which == Summand::P;
  return {(is_p ? "P: " : "Q: ") + counted(vertex_count(summand), "vertex", "vertices"),
          {{is_p ? style::summand_p : style::summand_q, summand}}};
}

std::vector<Panel> panels_of(const Region& p, const Region& q) {
  const std::vector<Segment> full = segments(convolution(p, q));
  const std::vector<Segment> reduced = segments(reduced_convolution(p, q));
  return {panel_of(Summand::P, p),
          panel_of(Summand::Q, q),
          {"Convolution: " + counted(full.size(), "segment", "segments"),
           {{style::convolution, {}, full}}},
          {"Reduced convolution: " + counted(reduced.size(), "segment", "segments"),
           {{style::reduced_convolution, {}, reduced}}}};
}

std::vector<Layer> layers_of(const MinkowskiSum& sum) {
  // A hole may have a part of the sum inside it, so the sum is drawn over the holes.
  Layer holes{style::holes};
  for (const Chain& hole : sum.holes)
    holes.region.components.push_back({Chain(hole.rbegin(), hole.rend()), {}});
  std::vector<Layer> layers = {holes,
                               {style::sum, region_of(sum)},
                               {style::dangling_edges, {}, sum.dangling_edges},
                               {style::isolated_vertices, {}, {}, sum.isolated_vertices}};
  std::erase_if(layers, [](const Layer& layer) {
    return layer.region.components.empty() && layer.segments.empty() && layer.points.empty();
  });
  return layers;
}

}  // namespace oplus
