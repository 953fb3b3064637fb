// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

namespace oplus {

namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void note(int) {
  interrupted = true;
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
  constexpr std::string_view text =
      "\ninterrupted: writing the report; a second interrupt ends the program at once\n";
  static_cast<void>(::write(STDERR_FILENO, text.data(), text.size()) < 0);
}

}  // namespace

void finish_when_interrupted() {
  for (const int signal : {SIGINT, SIGTERM})
    if (std::signal(signal, note) == SIG_IGN) std::signal(signal, SIG_IGN);
}

bool is_interrupted() { return interrupted; }

}  // namespace oplus
