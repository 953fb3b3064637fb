// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

/// A chain of a given sum, numbered as it was given, both from one; hole 0 is the outer chain.
struct GivenChain {
  std::size_t component;
  std::size_t hole;
  const Chain* vertices;
};

/// All chains, without those that have no vertex.
std::vector<GivenChain> given_chains(const GivenSum& sum);

/// Returns "the outer chain of component 1" or "hole 2 of component 1".
std::string describe(const GivenChain& chain);

}  // namespace oplus
