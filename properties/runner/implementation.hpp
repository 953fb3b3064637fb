// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// Anything that maps two regions to a sum, so that it can be held against the oracle.
struct Implementation {
  std::string name;
  std::function<MinkowskiSum(const Region& p, const Region& q, Boundary boundary)> sum;
};

/// The implementations of oplus, the default first.
const std::vector<Implementation>& implementations();

}  // namespace oplus
