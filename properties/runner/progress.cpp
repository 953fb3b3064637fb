// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/progress.hpp"

#include <unistd.h>

#include <iostream>
#include <utility>

#include "checked/cli/command_line/terminal.hpp"

namespace oplus {

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

void Progress::draw_bar() const {
  constexpr std::size_t width = 40;
  const std::size_t filled = width * done_ / total_;
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
  const double left =
      taken.count() / static_cast<double>(done_) * static_cast<double>(total_ - done_);
  std::cerr << '\r' << what_ << " [" << std::string(filled, '#') << std::string(width - filled, ' ')
            << "] " << done_ << '/' << total_ << ", " << static_cast<long>(left) << " s left   ";
  if (done_ == total_) std::cerr << '\n';
  std::cerr.flush();
}

}  // namespace oplus
