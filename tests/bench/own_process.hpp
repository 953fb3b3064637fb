// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "properties/runner/child_process.hpp"
#include "tests/bench/measurement.hpp"

namespace oplus {

/// Work that measures; it calls its argument as a sign of life.
using Measuring = std::function<Measurement(const std::function<void()>& beat)>;

/// Measures in a process that this one forks, and waits for it.
///  1. Work that throws, crashes, is killed, or runs into a limit is a measurement that says so, with
///     the most that was resident (wait4, ru_maxrss); it leaves this process alone.
///  2. Work that throws NotTaken has not been taken.
///  3. Of the limits, the time is that from one sign of life to the next.
/// Requires: no other thread runs. Throws std::system_error where no process can be had.
Measurement measured_in_own_process(const Measuring& work, ProcessLimits limits);

}  // namespace oplus
