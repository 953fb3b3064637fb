// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

/// A chain of a given sum, numbered as it was given, both from one; hole 0 is the outer chain.
struct ClaimedChain {
  std::size_t component;
  std::size_t hole;
  const Chain* vertices;
};

/// All chains, without those that have no vertex.
std::vector<ClaimedChain> claimed_chains(const ClaimedSum& sum);

/// Returns "the outer chain of component 1" or "hole 2 of component 1".
std::string describe(const ClaimedChain& chain);

}  // namespace oplus
