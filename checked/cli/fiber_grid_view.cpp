// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/view.hpp"
#include "checked/cycles/fiber_grid_picture.hpp"
#include "reference/pictures/stacked_pictures.hpp"

namespace oplus {

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
