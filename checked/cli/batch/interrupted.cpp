// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/interrupted.hpp"

#include <atomic>

#include "checked/cli/command_line/early_ends.hpp"

namespace oplus {

namespace {

std::atomic<int> noted = 0;
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int number) {
  noted = number;
  std::signal(number, end_by_signal);
}

/// A signal that is ignored stays so.
void note(int number, struct sigaction& before) {
  sigaction(number, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction handler {};
  handler.sa_handler = note_signal;
  handler.sa_flags = SA_RESTART;
  sigaction(number, &handler, nullptr);
}

}  // namespace

NotedInterrupt::NotedInterrupt() {
  noted = 0;
  note(SIGINT, before_of_interrupt_);
  note(SIGTERM, before_of_termination_);
}

NotedInterrupt::~NotedInterrupt() {
  sigaction(SIGINT, &before_of_interrupt_, nullptr);
  sigaction(SIGTERM, &before_of_termination_, nullptr);
}

bool NotedInterrupt::is_noted() { return noted != 0; }

void NotedInterrupt::end_program() { end_by_signal(noted); }

}  // namespace oplus
