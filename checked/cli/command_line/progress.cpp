// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/progress.hpp"

#include <unistd.h>

#include <iostream>
#include <utility>

#include "checked/cli/command_line/terminal.hpp"

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

void Progress::draw_bar() const {
  std::cerr << '\r' << bar(what_, done_, total_, std::chrono::steady_clock::now() - start_)
            << "   ";
  if (done_ == total_) std::cerr << '\n';
  std::cerr.flush();
}

}  // namespace oplus
