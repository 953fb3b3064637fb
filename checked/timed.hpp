// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include "checked/statistics.hpp"

namespace oplus {

/// Adds the time that `work` takes; returns what it returns.
template <typename Work>
auto timed(Seconds& total, Work work) {
  struct Clock {
    Seconds& total;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Clock() { total += std::chrono::steady_clock::now() - start; }
  } const clock{total};
  return work();
}

}  // namespace oplus
