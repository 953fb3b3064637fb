// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/progress.hpp"

#include <unistd.h>

#include <condition_variable>
#include <iostream>
#include <mutex>
#include <optional>
#include <utility>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/joined_thread.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

std::string bar(const std::string& what, std::size_t done, std::size_t total,
                std::chrono::duration<double> taken) {
  constexpr std::size_t width = 40;
  const std::size_t filled = width * done / total;
  const double left = taken.count() / static_cast<double>(done) * static_cast<double>(total - done);
  return what + " [" + std::string(filled, '#') + std::string(width - filled, ' ') + "] " +
         std::to_string(100 * done / total) + " %, " + std::to_string(static_cast<long>(left)) +
         " s left";
}

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)),
      total_(total),
      on_terminal_(isatty(STDERR_FILENO) != 0),
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

/// The stages that have begun and not ended, and the thread that shows the last of them. It exists as long as one
/// of them does.
class ShownStep::Display {
 public:
  /// Returns the one there is, or a new one.
  static std::shared_ptr<Display> of_the_program() {
    static std::mutex mutex;
    static std::weak_ptr<Display> of_all;
    const std::lock_guard lock(mutex);
    std::shared_ptr<Display> display = of_all.lock();
    if (!display) of_all = display = std::make_shared<Display>();
    return display;
  }

  Display() {
    if (isatty(STDERR_FILENO) != 0 && !speech().quiet) thread_.emplace([this] { show(); });
  }
  ~Display() {
    const std::lock_guard lock(mutex);
    is_over_ = true;
    over_.notify_all();
  }

  std::mutex mutex;
  std::list<Stage> stages;
  bool is_hidden = false;

 private:
  std::string line() const {
    const Stage& stage = stages.back();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - stage.start;
    return stage.done == 0
               ? stage.what + " ... " + std::to_string(static_cast<long>(taken.count())) + " s"
               : bar(stage.what, stage.done, stage.total, taken);
  }

  void show() {
    std::unique_lock lock(mutex);
    const auto over_within = [&](std::chrono::milliseconds time) {
      return over_.wait_for(lock, time, [&] { return is_over_; });
    };
    if (over_within(std::chrono::seconds(1))) return;
    do {
      if (!is_hidden && !stages.empty()) show_passing_line(line());
    } while (!over_within(std::chrono::milliseconds(200)));
    erase_passing_line();
  }

  std::condition_variable over_;
  bool is_over_ = false;
  std::optional<JoinedThread> thread_;  ///< the last: it is joined before the others are gone
};

ShownStep::ShownStep(std::string what) : display_(Display::of_the_program()) {
  const std::lock_guard lock(display_->mutex);
  stage_ = display_->stages.insert(display_->stages.end(),
                                   {std::move(what), std::chrono::steady_clock::now()});
}

ShownStep::~ShownStep() {
  const std::lock_guard lock(display_->mutex);
  display_->stages.erase(stage_);
}

void ShownStep::next(std::string what) {
  const std::lock_guard lock(display_->mutex);
  *stage_ = {std::move(what), std::chrono::steady_clock::now()};
}

void ShownStep::advance(std::size_t done, std::size_t total) {
  const std::lock_guard lock(display_->mutex);
  stage_->done = done;
  stage_->total = total;
}

void ShownStep::hide_all() {
  const std::shared_ptr<Display> display = Display::of_the_program();
  const std::lock_guard lock(display->mutex);
  display->is_hidden = true;
  erase_passing_line();
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
