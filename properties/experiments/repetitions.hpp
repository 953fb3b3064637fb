// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "checked/statistics.hpp"

namespace oplus {

/// How often to run what makes something of this size, so that a median says more than a run. Sizes
/// decide, not clocks: the same on every machine.
inline std::size_t repetitions(std::size_t size) {
  if (size <= 20'000) return 5;
  return size <= 600'000 ? 3 : 1;
}

/// The element in the middle when sorted. Requires: at least one, an odd number.
template <typename T, typename Key>
T median(std::vector<T> values, Key key) {
  std::sort(values.begin(), values.end(), [&](const T& a, const T& b) { return key(a) < key(b); });
  return values[values.size() / 2];
}

/// The median of the seconds that `work` takes; what it returns is freed outside of them.
template <typename Work>
double median_seconds(std::size_t times, Work work) {
  std::vector<double> seconds;
  while (seconds.size() < times) {
    Seconds duration{};
    const auto result = timed(duration, work);
    seconds.push_back(duration.count());
  }
  return median(std::move(seconds), [](double value) { return value; });
}

}  // namespace oplus
