// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/interrupted.hpp"

#include <unistd.h>

#include <atomic>

#include "checked/cli/command_line/early_ends.hpp"

namespace oplus {

namespace {

std::atomic<int> noted = 0;
static_assert(std::atomic<int>::is_always_lock_free);

/// What is said when the signal comes.
std::string_view message;

extern "C" void note_signal(int number) {
  if (noted != 0) end_by_signal(number);
  noted = number;
  [[maybe_unused]] const auto said = ::write(STDERR_FILENO, message.data(), message.size());
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

NotedInterrupt::NotedInterrupt(std::string_view said) {
  noted = 0;
  message = said;
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
