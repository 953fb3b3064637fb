// SPDX-License-Identifier: MIT
#include "reference/chains/nesting.hpp"

namespace oplus {

std::vector<const Chain*> chains_in(const Region& region) {
  std::vector<const Chain*> result;
  for (const Component& component : region.components) {
    result.push_back(&component.outer);
    for (const Chain& hole : component.holes) result.push_back(&hole);
  }
  return result;
}

SweptChains::SweptChains(const std::vector<const Chain*>& chains) {
  std::size_t count = 0;
  for (const Chain* chain : chains) count += chain->size();
  edges.points.reserve(count);
  edges.edges.reserve(count);
  chain_of.reserve(count);
  for (const Chain* chain : chains) {
    first_of_chain.push_back(static_cast<std::uint32_t>(chain_of.size()));
    chain_of.resize(chain_of.size() + chain->size(),
                    static_cast<std::uint32_t>(first_of_chain.size() - 1));
    edges.add(*chain);
  }
}

Nesting::Nesting(const SweptChains& chains)
    : chains_(chains), found_(chains.first_of_chain.size()) {}

void Nesting::pass(const SweptPlace& place) {
  std::optional<std::uint32_t> below = place.below;
  for (const std::uint32_t edge : place.right) {
    Found& chain = found_[chains_.chain_of[edge]];
    if (!chain.is_passed) {
      // At its smallest vertex, a chain winds around what is above its lowest edge, not around what is
      // below it.
      chain.is_passed = true;
      chain.is_counterclockwise = chains_.edges.runs_right(edge);
      if (below) {
        const std::uint32_t other = chains_.chain_of[*below];
        const bool is_inside =
            chains_.edges.runs_right(*below) == found_[other].is_counterclockwise;
        chain.around = is_inside ? other : found_[other].around;
      }
    }
    below = edge;
  }
}

Nesting nesting(const SweptChains& chains) {
  Nesting result(chains);
  sweep(chains.edges, [&](const SweptPlace& place) {
    result.pass(place);
    return true;
  });
  return result;
}

}  // namespace oplus
