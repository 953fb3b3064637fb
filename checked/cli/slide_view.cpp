// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/view.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/slide/slide.hpp"
#include "reference/io/counted.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

std::string slide_view(const Region& p, const Region& q) {
  const ComputedSum result = slide_sum(p, q, Boundary::closed);
  std::vector<Layer> layers = layers_of(result.sum);
  layers.push_back({style::reduced_convolution, {}, segments(traced_reduced_convolution(p, q))});
  return beside_summands(
      p, q,
      "Reduced convolution: " +
          counted(result.statistics.count("segments slid along"), "segment", "segments") + ", " +
          counted(result.statistics.count("free pieces of segments"), "free piece", "free pieces"),
      std::move(layers));
}

}  // namespace oplus
