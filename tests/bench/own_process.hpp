// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "properties/runner/child_process.hpp"
#include "tests/bench/measurement.hpp"

namespace oplus {

/// Work that measures; it calls its argument to show that it is alive.
using Measuring = std::function<Measurement(const std::function<void()>& beat)>;

/// Measures in a forked process, and waits for it.
///  1. Work that throws, crashes, is killed, or exceeds a limit gives a measurement with that outcome and
///     the peak resident memory (wait4, ru_maxrss); it does not affect this process.
///  2. If the work throws Unsupported, the outcome is `unsupported`.
///  3. The time limit is that from one call of `beat` to the next.
/// Requires: no other thread runs. Throws std::system_error if it cannot fork.
Measurement measured_in_own_process(const Measuring& work, ProcessLimits limits);

}  // namespace oplus
