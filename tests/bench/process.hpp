// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace oplus {

/// What became of a program.
struct EndedProcess {
  enum class How { exited, killed_by_signal, over_limit };
  How how = How::exited;
  int code = 0;        ///< the exit code, or the signal
  std::string output;  ///< what it wrote to standard output
  double peak_mb = 0;  ///< resident at most (wait4, ru_maxrss), in units of 10^6 bytes
};

/// Runs a program and waits for it. Each line it writes starts its clock anew; where that passes the
/// limit, in seconds, it is killed. Throws std::system_error where it cannot be started.
EndedProcess run_process(const std::vector<std::string>& command, double limit);

/// The path of the program that is running.
std::string own_path();

/// The process that calls this is killed when the one that started it ends.
void end_with_parent();

/// Resident at most until now, in units of 10^6 bytes.
double own_peak_mb();

}  // namespace oplus
