// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "tests/bench/engine.hpp"
#include "tests/bench/own_process.hpp"

namespace oplus {

/// A run that takes longer than this, in seconds, is not repeated.
inline constexpr double long_run = 1;
inline constexpr int repetitions = 5;

/// Measures an engine on a row with Google Benchmark: one run and, unless that is a long one,
/// `repetitions` of one or more runs, which take `min_time` seconds in all.
/// In a process of its own, which makes the row. Each step, such as preparing the pairs, a run, or
/// describing the results, may take `limits.seconds`.
Measurement measured(const BenchEngine& engine, const Row& row, double min_time,
                     const ProcessLimits& limits);

/// Measures these of the row's engines, one after another, and writes a table at the same time:
/// a head, a line per engine, and how the results compare.
void measure(Row& row, const std::vector<std::string>& engines, double min_time,
             const ProcessLimits& limits, std::ostream& out);

}  // namespace oplus
