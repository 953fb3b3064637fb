// SPDX-License-Identifier: MIT
#include "reference/definitions/claimed_sum.hpp"

namespace oplus {

std::vector<ClaimedChain> claimed_chains(const ClaimedSum& sum) {
  std::vector<ClaimedChain> result;
  for (std::size_t c = 0; c < sum.region.components.size(); ++c) {
    const Component& component = sum.region.components[c];
    if (!component.outer.empty()) result.push_back({c + 1, 0, &component.outer});
    for (std::size_t h = 0; h < component.holes.size(); ++h)
      if (!component.holes[h].empty()) result.push_back({c + 1, h + 1, &component.holes[h]});
  }
  return result;
}

std::string describe(const ClaimedChain& chain) {
  return (chain.hole == 0 ? "the outer chain" : "hole " + std::to_string(chain.hole)) +
         " of component " + std::to_string(chain.component);
}

}  // namespace oplus
