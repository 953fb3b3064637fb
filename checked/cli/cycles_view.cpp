// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/cli/view.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/cycles/fiber_grid_picture.hpp"
#include "reference/io/counted.hpp"
#include "reference/pictures/stacked_pictures.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

namespace {

/// Its size and how often it goes round each summand's chain; which chains where there are several.
std::string described(const ConvolutionCycle& cycle, const std::vector<Chain>& chains_of_p,
                      const std::vector<Chain>& chains_of_q) {
  const auto of_p = static_cast<std::size_t>(
      std::count_if(cycle.begin(), cycle.end(),
                    [](const ConvolutionSegment& s) { return s.origin.edge_of == Summand::P; }));
  const Origin& origin = cycle.front().origin;
  const auto [p, q] = origin.edge_of == Summand::P
                          ? std::pair{origin.edge.chain, origin.vertex.chain}
                          : std::pair{origin.vertex.chain, origin.edge.chain};
  const auto rounds = [](const std::string& summand, std::size_t chain,
                         const std::vector<Chain>& chains, std::size_t steps) {
    return summand + (chains.size() > 1 ? " chain " + std::to_string(chain) : "") + " " +
           std::to_string(steps / chains[chain].size()) + "\u00d7";
  };
  return counted(cycle.size(), "segment", "segments") + ": " + rounds("P", p, chains_of_p, of_p) +
         ", " + rounds("Q", q, chains_of_q, cycle.size() - of_p);
}

}  // namespace

std::string cycles_view(const Region& p, const Region& q) {
  const ConvolutionCycles traced = convolution_cycles(p, q);
  const std::vector<Chain> chains_of_p = chains(p);
  const std::vector<Chain> chains_of_q = chains(q);
  std::vector<Layer> layers;
  std::size_t size = 0;
  for (const ConvolutionCycle& cycle : traced.cycles) {
    layers.push_back({labelled(style::cycle(static_cast<int>(layers.size())),
                               described(cycle, chains_of_p, chains_of_q)),
                      {},
                      segments(cycle)});
    size += cycle.size();
  }
  return beside_summands(p, q,
                         "Convolution: " + counted(size, "segment", "segments") + " in " +
                             counted(layers.size(), "cycle", "cycles"),
                         layers);
}

std::string fiber_grid_view(const Region& p, const Region& q) {
  const std::vector<Chain> chains_of_p = chains(p);
  const std::vector<Chain> chains_of_q = chains(q);
  if (chains_of_p.size() == 1 && chains_of_q.size() == 1)
    return svg(fiber_grid(chains_of_p[0], chains_of_q[0]));
  std::vector<TitledPicture> grids;
  for (std::size_t a = 0; a < chains_of_p.size(); ++a) {
    for (std::size_t b = 0; b < chains_of_q.size(); ++b)
      grids.push_back({"Chain " + std::to_string(a) + " of P, chain " + std::to_string(b) + " of Q",
                       svg(fiber_grid(chains_of_p[a], chains_of_q[b]))});
  }
  return stacked(grids);
}

}  // namespace oplus
