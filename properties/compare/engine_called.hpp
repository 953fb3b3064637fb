// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "checked/engine.hpp"
#include "properties/runner/child_process.hpp"

namespace oplus {

/// The methods of other libraries (peers/peer_table.hpp), in the order in which they are listed. Each
/// runs `oplus-peer` for each sum, with these limits; see engine_called().
std::vector<Engine> peers(ProcessLimits limits = {});

/// Sums by `oplus-proved`, a program beside this one, for pairs whose convolution has at most so many segments;
/// others it refuses. It fails as program_engine() does.
Engine proved_engine(ProcessLimits limits,
                     std::size_t most_segments = std::numeric_limits<std::size_t>::max());

/// Returns an engine that runs another library or program in a process of its own for each sum; nullopt
/// where `engine` is neither "certified" (certified_engine.hpp) nor "proved" nor the name of a peer nor "exec:" and a
/// command.
/// Its compute() throws EngineFailure, and std::system_error where no process or file can be made, or, with the
/// code std::errc::interrupted, where it was interrupted (ProcessLimits); any number of threads may call it.
std::optional<Engine> engine_called(const std::string& engine, const ProcessLimits& limits);

/// Runs the command of an engine "exec:…" once, on two squares. Returns what the shell says where it
/// cannot run the command; why "certified", "proved" or a peer cannot run, and how it is built; else "".
std::string why_it_cannot_run(const std::string& engine, ProcessLimits limits);

/// Any program as an engine. The shell runs the command, in which
///  1. {p} and {q} are replaced by the names of two files, the summands in WKT: absolute, and of
///     letters, digits and "/._-" only, so that they need no quotes and may be in quotes;
///     where the command contains neither, both are appended;
///  2. {boundary} is replaced by closed or open; where it is missing, the program computes closed
///     sums, and open ones are unsupported.
/// It writes the sum to its standard output, in any format that read_sum reads, and exits with 0; with 77
/// (exit_refused) where it does not support such a pair, the reason on standard error. Anything else is a
/// fault.
Engine program_engine(const std::string& command, ProcessLimits limits);

}  // namespace oplus
