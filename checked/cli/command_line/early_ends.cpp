// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/early_ends.hpp"

#include <fcntl.h>
#include <gmp.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "checked/cli/command_line/number_memory.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/exit_code.hpp"
#include "reference/io/output_file.hpp"

namespace oplus {

namespace {

extern "C" void handle_end(int number) { end_by_signal(number); }

// GMP has no way to report a failure: its own functions abort.
void* unless_null(void* memory) {
  if (memory == nullptr) end_without_memory();
  return memory;
}
extern "C" void* allocate(std::size_t size) { return unless_null(NumberMemory::allocate(size)); }
extern "C" void* reallocate(void* old, std::size_t old_size, std::size_t size) {
  return unless_null(NumberMemory::reallocate(old, old_size, size));
}
extern "C" void release(void* memory, std::size_t size) { NumberMemory::release(memory, size); }

/// The beginning of a file of the system, without a stream, which takes as long to start as a small sum; else empty.
std::string beginning_of(const char* path) {
  constexpr unsigned most = 4096;
  std::string text(most, '\0');
  const int file = ::open(path, O_RDONLY | O_CLOEXEC);
  const auto length = file < 0 ? 0 : ::read(file, text.data(), most);
  if (file >= 0) ::close(file);
  text.resize(static_cast<std::size_t>(std::max<decltype(length)>(length, 0)));
  return text;
}

/// What the machine, or the container, has left, in bytes.
rlim_t available_memory() {
  const std::string machine = beginning_of("/proc/meminfo");
  const auto kilobytes = [&](const char* name) -> rlim_t {
    const std::size_t place = machine.find(name);
    return place == std::string::npos
               ? 0
               : std::strtoull(machine.c_str() + place + std::strlen(name), nullptr, 10);
  };
  const rlim_t left = 1024 * (kilobytes("MemAvailable:") + kilobytes("SwapFree:"));
  // "max", which is read as 0, where there is none.
  const std::string container = beginning_of("/sys/fs/cgroup/memory.max");
  const rlim_t most = std::strtoull(container.c_str(), nullptr, 10);
  return std::min(left == 0 ? RLIM_INFINITY : left, most == 0 ? RLIM_INFINITY : most);
}

/// An allocation then fails, where the system would end the program, or another one, without a word.
void limit_memory() {
#ifndef __SANITIZE_ADDRESS__  // it reserves terabytes
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_cur, available_memory());
  setrlimit(RLIMIT_DATA, &limit);
#endif
}

/// Of an exception that no one catches, on another thread for example.
[[noreturn]] void end_for_exception() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (...) {
  }
  std::abort();
}

}  // namespace

void prepare_for_early_ends() {
  for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU}) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler != SIG_DFL) continue;
    action.sa_handler = handle_end;
    sigaction(number, &action, nullptr);
  }
  signal(SIGXFSZ, SIG_IGN);
  limit_memory();
  mp_set_memory_functions(allocate, reallocate, release);
  std::set_terminate(end_for_exception);
}

void end_by_signal(int number) {
  remove_temporary_files();
  signal(number, SIG_DFL);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, number);
  sigprocmask(SIG_UNBLOCK, &only, nullptr);
  ::kill(::getpid(), number);
  // As a shell would say it, should it not have ended.
  _exit(128 + number);
}

void end_without_memory() noexcept {
  // Without a copy, for which there may be no memory either.
  const auto say = [](std::string_view text) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  };
  say(speech().program);
  say(": there is not enough memory for this input\n");
  remove_temporary_files();
  _exit(static_cast<int>(ExitCode::invalid));
}

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
