// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <string_view>

namespace oplus {

/// As long as it lives, Ctrl-C and SIGTERM are noted, so that the program can end between two lines and
/// without leaving a temporary file. The second one ends it at once. A signal that is ignored stays ignored.
class NotedInterrupt {
 public:
  /// The first one says this on standard error. Requires: a text that lasts.
  explicit NotedInterrupt(std::string_view said = {});
  NotedInterrupt(const NotedInterrupt&) = delete;
  NotedInterrupt& operator=(const NotedInterrupt&) = delete;
  ~NotedInterrupt();

  /// Whether there was one. Any thread may call it.
  static bool is_noted();

  /// Ends the program by the signal that was noted, as if nothing had noted it.
  /// Requires: is_noted().
  [[noreturn]] static void end_program();

 private:
  struct sigaction before_of_interrupt_ {};
  struct sigaction before_of_termination_ {};
};

}  // namespace oplus
