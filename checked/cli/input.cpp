// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/input.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <thread>

#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

namespace {

/// Shows on a terminal how far the reading of a file is, from the second second on; leaves no trace.
/// In a thread of its own, since the validity check reports nothing.
class ShownReading {
 public:
  explicit ShownReading(const std::string& path) {
    if (isatty(STDERR_FILENO) == 1 && !speech().quiet)
      thread_ = std::jthread([this, name = path == "-" ? "standard input" : one_line(path)](
                                 const std::stop_token& stop) { show(name, stop); });
  }

  /// What reading is to call.
  ReadingProgress progress() {
    return [this](int percent) { percent_ = percent; };
  }

 private:
  void show(const std::string& name, const std::stop_token& stop) {
    constexpr const char* to_the_end = "\033[K";  // erases
    const auto start = std::chrono::steady_clock::now();
    std::mutex unshared;
    std::unique_lock lock(unshared);
    const auto stopped_within = [&](std::chrono::milliseconds time) {
      return stopped_.wait_for(lock, stop, time, [&] { return stop.stop_requested(); });
    };
    if (stopped_within(std::chrono::seconds(1))) return;
    do {
      const int percent = percent_;
      const std::string line = percent == 100 ? "checking " + name + " ..."
                               : percent == 0
                                   ? "reading " + name + " ..."
                                   : bar("reading " + name, static_cast<std::size_t>(percent), 100,
                                         std::chrono::steady_clock::now() - start);
      std::cerr << "\r" << line << to_the_end << std::flush;
    } while (!stopped_within(std::chrono::milliseconds(200)));
    std::cerr << "\r" << to_the_end << std::flush;
  }

  std::atomic<int> percent_ = 0;
  std::condition_variable_any stopped_;
  std::jthread thread_;  // the last: it is joined before the others are gone
};

}  // namespace

Region read_summand(const std::string& path) {
  ReadRegion read = read_region_file(path, ShownReading(path).progress());
  for (const std::string& note : read.notes) say_note(note);
  return std::move(read.region);
}

MinkowskiSum read_given_sum(const std::string& path) {
  ReadSum read = read_sum_file(path, ShownReading(path).progress());
  for (const std::string& note : read.notes) say_note(note);
  return std::move(read.sum);
}

GivenSum read_unchecked_sum(const std::string& path) {
  return read_unchecked_sum_file(path, ShownReading(path).progress());
}

void require_one_standard_input(const std::vector<std::string>& paths) {
  if (std::count(paths.begin(), paths.end(), "-") > 1)
    throw UsageError("standard input (-) can be read only once; give the others as files");
}

}  // namespace oplus
