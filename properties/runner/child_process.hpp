// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace oplus {

/// What a process may use.
struct ProcessLimits {
  double seconds = std::numeric_limits<double>::infinity();
  std::size_t address_space_mb = 0;    ///< per process, in units of 10^6 bytes; 0: unlimited
  std::size_t output_mb = 0;           ///< of its standard output; 0: unlimited
  bool is_quiet = false;               ///< standard error is kept, not passed on
  bool (*is_interrupted)() = nullptr;  ///< if set: asked ten times a second whether to kill it
};

/// How a process ended.
struct EndedProcess {
  enum class How { exited, killed_by_signal, over_time, over_output, interrupted };
  How how = How::exited;
  int code = 0;        ///< the exit code, or the signal
  std::string output;  ///< what it wrote
  std::string errors;  ///< the end of what it wrote to standard error, where that is kept
  double peak_mb = 0;  ///< resident at most (wait4, ru_maxrss), in units of 10^6 bytes
};

/// Runs a program, found as a shell finds it, its standard input empty, and waits for it.
///  1. It has ended when the process that was started has. What that process started and left behind
///     is killed then, unless it has made itself leader of a group; so is all of it where a limit is
///     passed, and where the thread that called this ends.
///  2. Any number of threads may run programs at a time.
/// Throws std::system_error where it cannot be started.
EndedProcess run_program(const std::vector<std::string>& command, const ProcessLimits& limits);

/// The program of this name beside the one that is running, which "" is.
std::string program_beside(const std::string& name);

/// The largest resident size until now, in units of 10^6 bytes.
double own_peak_mb();

/// "SIGSEGV" for 11; "signal 99" for one without a name.
std::string signal_name(int signal);

}  // namespace oplus
