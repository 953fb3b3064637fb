// SPDX-License-Identifier: MIT
#include <utility>

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

Panel convolution_panel(std::vector<Segment> convolution) {
  return {"Convolution: " + counted(convolution.size(), "segment", "segments"),
          {{style::convolution, {}, std::move(convolution)}}};
}

Panel reduced_convolution_panel(std::vector<Segment> reduced) {
  return {"Reduced convolution: " + counted(reduced.size(), "segment", "segments"),
          {{style::reduced_convolution, {}, std::move(reduced)}}};
}

std::vector<Panel> panels_of(const Region& p, const Region& q) {
  return {panel_of(Summand::P, p), panel_of(Summand::Q, q),
          convolution_panel(segments(convolution(p, q))),
          reduced_convolution_panel(segments(reduced_convolution(p, q)))};
}

std::vector<Layer> layers_of(const PlanarSet& sum) {
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
