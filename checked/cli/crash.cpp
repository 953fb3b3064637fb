// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/crash.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <string_view>

#include "checked/cli/exit_code.hpp"
#include "reference/io/output_file.hpp"

namespace oplus {

namespace {

/// Only what is safe in a signal handler.
extern "C" void report_and_exit(int) {
  constexpr std::string_view line =
      "oplus: a bug in oplus: the program crashed; please report it with the input\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
  remove_temporary_files();
  _exit(static_cast<int>(ExitCode::bug));
}

/// A stack of its own for the handler: the program's may be what overflowed.
std::array<char, 1 << 16> handler_stack;

}  // namespace

void report_crashes() {
  stack_t stack{};
  stack.ss_sp = handler_stack.data();
  stack.ss_size = handler_stack.size();
  const bool has_stack = sigaltstack(&stack, nullptr) == 0;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_DFL) continue;
    struct sigaction handler {};
    handler.sa_handler = report_and_exit;
    handler.sa_flags = has_stack ? SA_ONSTACK : 0;
    sigaction(signal, &handler, nullptr);
  }
}

}  // namespace oplus
