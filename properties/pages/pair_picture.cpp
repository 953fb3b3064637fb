// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/pair_picture.hpp"

#include <algorithm>

#include "checked/arrangement/rca.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

std::string picture_of_pair(const Summands& pair) {
  std::vector<Layer> layers = layers_of(rca(pair.p, pair.q, Boundary::open).sum);
  // Over the region, below dangling edges and isolated vertices.
  const auto above_region = std::find_if_not(layers.begin(), layers.end(), [](const Layer& layer) {
    return !layer.region.components.empty();
  });
  layers.insert(above_region, {style::convolution, {}, segments(convolution(pair.p, pair.q))});
  return svg({panel_of(Summand::P, pair.p),
              panel_of(Summand::Q, pair.q),
              {"Convolution and open sum", std::move(layers)}});
}

}  // namespace oplus
