// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace oplus {

/// What became of work in a process of its own.
struct ProcessReport {
  enum class Kind { done, out_of_memory, failed };
  Kind kind = Kind::done;
  std::string text;  ///< what the work returned, or what happened to it, in a few words
  double peak_mb = 0;
};

/// Runs work in a process that this one forks, and waits for it.
///  1. Its peak memory is the most that was resident at a time (wait4, ru_maxrss, in units of 10^6
///     bytes): all of the work, what it returns, the program itself, and what this process had.
///  2. Work that throws, crashes or is killed is reported, and leaves this process alone.
///  3. Work that needs more address space than the limit is out of memory. 0 is no limit; nor is
///     there one under the address sanitizer, which reserves terabytes.
/// Requires: no other thread runs. Throws std::system_error where no process can be had.
ProcessReport in_process_of_its_own(const std::function<std::string()>& work,
                                    std::size_t memory_limit_mb);

}  // namespace oplus
