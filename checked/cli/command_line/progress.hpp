// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace oplus {

/// Returns a line for a terminal: "what [####    ] 4/8, 3 s left", given the time taken so far.
/// Requires: 0 < done <= total.
std::string bar(const std::string& what, std::size_t done, std::size_t total,
                std::chrono::duration<double> taken);

/// Shows on standard error how far a run is: a bar on a terminal, else a plain line every tenth;
/// nothing with --quiet.
class Progress {
 public:
  Progress(std::string what, std::size_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void advance();

  /// That a counterexample is shrunk: a line on a terminal that changes, else one at the first try.
  void shrink(const std::string& kind, std::size_t vertices, std::size_t tries);

 private:
  void draw_bar();
  void end_line();

  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool on_terminal_;
  bool has_open_line_ = false;
  std::string shrunk_kind_;
  std::chrono::steady_clock::time_point start_;
};

/// Shows on a terminal what takes long, and how far it is where that is known, from the second second on;
/// leaves no trace. Nothing elsewhere, and nothing with --quiet.
class ShownStep {
 public:
  explicit ShownStep(std::string what);
  ShownStep(const ShownStep&) = delete;
  ShownStep& operator=(const ShownStep&) = delete;

  /// Says that the next step begins.
  void next(std::string what);

  /// Says how far the step is. May be called on any thread.
  void advance(std::size_t done, std::size_t total);

 private:
  void show(const std::stop_token& stop);
  std::string line() const;

  std::string what_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
  std::chrono::steady_clock::time_point start_;  ///< of the step
  std::mutex mutex_;                             ///< of all these
  std::condition_variable_any stopped_;
  std::jthread thread_;  ///< the last: it is joined before the others are gone
};

}  // namespace oplus
