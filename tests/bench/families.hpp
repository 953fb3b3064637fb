// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/row.hpp"

namespace oplus {

/// Sizes from `smallest` to `largest`.
struct SizeRange {
  std::size_t smallest;
  std::size_t largest;
  std::size_t step = 0;  ///< 0: each size is twice the previous one
};

/// The sizes of a range whose largest is scaled; always the smallest.
std::vector<std::size_t> sizes(const SizeRange& range, double scale);

/// Random bits per size of an experiment: a pair does not depend on what else runs.
Random random_of(const std::string& experiment, std::uint64_t seed, std::size_t size);

/// The row of a pair, made from random_of(); with the numbers `size` and `pair`.
Row random_row(const std::string& experiment, std::uint64_t seed, std::size_t size,
               const std::function<Summands(Random& random, std::size_t size)>& make);

/// A pair of a polygon of this size and one of 100 vertices.
template <Region (*p_of)(Random&, std::size_t), Region (*q_of)(Random&, std::size_t)>
Summands with_100(Random& random, std::size_t size) {
  return {p_of(random, size), q_of(random, 100)};  // in this order
}

}  // namespace oplus
