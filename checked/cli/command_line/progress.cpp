// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/progress.hpp"

#include <unistd.h>

#include <iostream>
#include <utility>

#include "checked/cli/command_line/terminal.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

std::string bar(const std::string& what, std::size_t done, std::size_t total,
                std::chrono::duration<double> taken) {
  constexpr std::size_t width = 40;
  const std::size_t filled = width * done / total;
  const double left = taken.count() / static_cast<double>(done) * static_cast<double>(total - done);
  return what + " [" + std::string(filled, '#') + std::string(width - filled, ' ') + "] " +
         std::to_string(done) + '/' + std::to_string(total) + ", " +
         std::to_string(static_cast<long>(left)) + " s left";
}

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      on_terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

void Progress::advance() {
  ++done_;
  if (speech().quiet) return;
  if (on_terminal_)
    draw_bar();
  else if (done_ == total_ || done_ * 10 / total_ != (done_ - 1) * 10 / total_)
    std::cerr << what_ << ": " << done_ << " of " << total_ << std::endl;
}

Progress::~Progress() { end_line(); }

void Progress::shrink(const std::string& kind, std::size_t vertices, std::size_t tries) {
  if (speech().quiet || (!on_terminal_ && kind == shrunk_kind_)) return;
  if (kind != shrunk_kind_) end_line();
  shrunk_kind_ = kind;
  constexpr std::size_t most = 40;  // a longer line would be broken on a terminal
  std::cerr << (on_terminal_ ? "\r" : "") << "shrinking "
            << (kind.size() > most ? kind.substr(0, most - 3) + "..." : kind) << ": " << vertices
            << " vertices, " << counted(tries, "pair", "pairs") << " tried";
  has_open_line_ = on_terminal_;
  if (!on_terminal_) std::cerr << '\n';
  std::cerr.flush();
}

ShownStep::ShownStep(std::string what)
    : what_(std::move(what)), start_(std::chrono::steady_clock::now()) {
  if (isatty(STDERR_FILENO) == 1 && !speech().quiet)
    thread_ = std::jthread([this](const std::stop_token& stop) { show(stop); });
}

void ShownStep::next(std::string what) {
  const std::lock_guard lock(mutex_);
  what_ = std::move(what);
  done_ = 0;
  start_ = std::chrono::steady_clock::now();
}

void ShownStep::advance(std::size_t done, std::size_t total) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  total_ = total;
}

std::string ShownStep::line() const {
  return done_ == 0 ? what_ + " ..."
                    : bar(what_, done_, total_, std::chrono::steady_clock::now() - start_);
}

void ShownStep::show(const std::stop_token& stop) {
  constexpr const char* to_the_end = "\033[K";  // erases
  std::unique_lock lock(mutex_);
  const auto stopped_within = [&](std::chrono::milliseconds time) {
    return stopped_.wait_for(lock, stop, time, [&] { return stop.stop_requested(); });
  };
  if (stopped_within(std::chrono::seconds(1))) return;
  do {
    std::cerr << "\r" << line() << to_the_end << std::flush;
  } while (!stopped_within(std::chrono::milliseconds(200)));
  std::cerr << "\r" << to_the_end << std::flush;
}

void Progress::end_line() {
  if (has_open_line_) std::cerr << std::endl;
  has_open_line_ = false;
}

void Progress::draw_bar() {
  std::cerr << '\r' << bar(what_, done_, total_, std::chrono::steady_clock::now() - start_)
            << "   ";
  std::cerr.flush();
  has_open_line_ = true;
  if (done_ == total_) end_line();
}

}  // namespace oplus
