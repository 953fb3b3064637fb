// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/engine.hpp"
#include "tests/bench/rows.hpp"

namespace oplus {

/// A run that takes longer than this, in seconds, is not repeated.
inline constexpr double long_run = 1;
inline constexpr std::size_t least_runs = 3;

/// Measures an engine on a row in this process: as many runs as take `min_time` seconds, at least
/// three; but none after a long one. Writes a line to standard output when the pairs are ready, after
/// runs, and the measurement as a line of JSON at the end. Ends the process.
[[noreturn]] void work(const BenchmarkedEngine& engine, const BenchRow& row, double min_time);

/// The same in a worker: this program started again. Each thing it does, from preparing the pairs to a
/// run to describing the results, may take `limit` seconds. Never throws for what a worker does.
Measurement measured_in_worker(const BenchmarkedEngine& engine, const BenchRow& row,
                               double min_time, double limit);

}  // namespace oplus
