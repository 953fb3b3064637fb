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
  std::size_t step;
};

/// The sizes of a range whose largest is scaled; always the smallest.
std::vector<std::size_t> sizes(const SizeRange& range, double scale);

/// Doubles from the smallest to the largest, which is scaled; always the smallest.
std::vector<std::size_t> doubling_sizes(std::size_t smallest, std::size_t largest, double scale);

/// Random bits of their own for each pair of each experiment: a pair is the same whatever else runs.
Random random_of(const std::string& experiment, std::uint64_t seed, std::size_t size,
                 std::size_t index);

/// The row of a pair, made from bits of its own; its columns `size` and `pair`.
Row random_row(const std::string& experiment, std::uint64_t seed, std::size_t size,
               const std::function<Summands(Random& random, std::size_t size)>& make);

}  // namespace oplus
