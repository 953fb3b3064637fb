// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/random/uniform_int_distribution.hpp>
#include <random>

namespace oplus {

/// Random bits that are the same on every compiler: the engine is fixed by the standard, and numbers
/// are drawn from it by Boost, not by the standard library, whose distributions differ.
using Random = std::mt19937_64;

/// Returns an integer in [low, high], each equally likely.
inline int uniform(Random& random, int low, int high) {
  return boost::random::uniform_int_distribution<int>(low, high)(random);
}

}  // namespace oplus
