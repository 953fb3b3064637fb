// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <list>
#include <memory>
#include <string>

namespace oplus {

/// Returns a line for a terminal: "what [####    ] 50 %, 3 s left", given the time taken so far.
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

/// A stage of what a program does. From the first second on, a terminal shows the last one that began and has not
/// ended, with its share done where that is known, and the seconds since it began where it is not; no trace of it
/// stays. Shows nothing elsewhere, and nothing with --quiet. run_program has one for the whole command, so
/// that no command is silent.
class ShownStep {
 public:
  explicit ShownStep(std::string what);
  ShownStep(const ShownStep&) = delete;
  ShownStep& operator=(const ShownStep&) = delete;
  ~ShownStep();

  /// Says that the next step begins.
  void next(std::string what);

  /// Says how far the step is. May be called on any thread.
  void advance(std::size_t done, std::size_t total);

  /// Shows no step any more: to be called before results go to the terminal.
  static void hide_all();

 private:
  class Display;
  struct Stage {
    std::string what;
    std::chrono::steady_clock::time_point start;
    std::size_t done = 0;
    std::size_t total = 0;
  };

  std::shared_ptr<Display> display_;
  std::list<Stage>::iterator stage_;
};

}  // namespace oplus
