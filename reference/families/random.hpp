// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/random/uniform_int_distribution.hpp>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace oplus {

/// Random bits that are the same on every compiler: the engine is fixed by the standard, and
/// numbers are drawn from it by Boost, not by the standard library, whose distributions differ.
/// Draw one number a statement or within braces: the order of a call's arguments is up to the
/// compiler.
using Random = std::mt19937_64;

/// Returns an integer in [low, high], each equally likely.
inline int uniform(Random& random, int low, int high) {
  return boost::random::uniform_int_distribution<int>(low, high)(random);
}

/// Returns an index in [0, size), each equally likely. Requires: size > 0.
inline std::size_t uniform_index(Random& random, std::size_t size) {
  return boost::random::uniform_int_distribution<std::size_t>(0, size - 1)(random);
}

/// True once in `times`, on average.
inline bool one_in(Random& random, int times) { return uniform(random, 1, times) == 1; }

/// Brings the elements into a random order, each equally likely.
template <typename T>
void shuffle(Random& random, std::vector<T>& elements) {
  for (std::size_t i = elements.size(); i > 1; --i)
    std::swap(elements[i - 1], elements[uniform_index(random, i)]);
}

}  // namespace oplus
