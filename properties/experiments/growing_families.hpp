// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "properties/experiments/experiment.hpp"
#include "reference/families/family.hpp"

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

/// Pairs in which P grows and Q does not.
struct GrowingFamily {
  std::string name;
  SizeRange sizes;
  std::size_t pairs;  ///< of each size
  Summands (*make)(Random& random, std::size_t size);
};

/// Both engines on every pair of the family: measured_engines, with the columns `size` and `pair`.
Table measured_family(const GrowingFamily& family, const ExperimentSettings& settings,
                      std::vector<std::string>& wrong);

}  // namespace oplus
