// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/process_of_its_own.hpp"

#include <gmp.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <system_error>

namespace oplus {

namespace {

constexpr int exit_done = 0;
constexpr int exit_threw = 1;
constexpr int exit_out_of_memory = 2;

[[noreturn]] void stop_out_of_memory() { ::_exit(exit_out_of_memory); }

void* or_out_of_memory(void* memory) {
  if (memory == nullptr) stop_out_of_memory();
  return memory;
}

/// Whoever asks for too much ends the process at once. GMP would abort, which looks like a fault.
void limit_memory(std::size_t limit_mb) {
  std::set_new_handler(stop_out_of_memory);
  ::mp_set_memory_functions([](std::size_t size) { return or_out_of_memory(std::malloc(size)); },
                            [](void* old, std::size_t, std::size_t size) {
                              return or_out_of_memory(std::realloc(old, size));
                            },
                            [](void* memory, std::size_t) { std::free(memory); });
#ifndef __SANITIZE_ADDRESS__
  if (limit_mb == 0) return;
  const rlimit limit{limit_mb * 1'000'000, limit_mb * 1'000'000};
  ::setrlimit(RLIMIT_AS, &limit);
#else
  static_cast<void>(limit_mb);
#endif
}

void write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(file, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) return;
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

std::string read_all(int file) {
  std::string text;
  std::array<char, 4096> part;
  while (true) {
    const ssize_t got = ::read(file, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(got));
  }
}

/// What the forked process does. It never returns: what this process would do at its end, such as
/// writing what is buffered, is not the fork's to do.
[[noreturn]] void work_and_exit(const std::function<std::string()>& work, std::size_t limit_mb,
                                int result) {
  int code = exit_done;
  try {
    limit_memory(limit_mb);
    write_all(result, work());
  } catch (const std::bad_alloc&) {
    code = exit_out_of_memory;
  } catch (const std::exception& e) {
    write_all(result, e.what());
    code = exit_threw;
  } catch (...) {
    code = exit_threw;
  }
  ::_exit(code);
}

std::system_error no_process() {
  return {errno, std::generic_category(), "a measurement gets no process of its own"};
}

ProcessReport report_of(int status, std::string text) {
  using Kind = ProcessReport::Kind;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return {Kind::failed, "killed by signal " + std::to_string(signal) + ", " + ::strsignal(signal),
            0};
  }
  switch (WEXITSTATUS(status)) {
    case exit_done:
      return {Kind::done, std::move(text), 0};
    case exit_out_of_memory:
      return {Kind::out_of_memory, "out of memory", 0};
    default:
      return {Kind::failed, "threw: " + text, 0};
  }
}

}  // namespace

ProcessReport in_process_of_its_own(const std::function<std::string()>& work,
                                    std::size_t memory_limit_mb) {
  std::array<int, 2> ends;
  if (::pipe(ends.data()) != 0) throw no_process();
  const auto [to_read, to_write] = ends;
  const pid_t process = ::fork();
  if (process < 0) {
    const std::system_error failure = no_process();
    ::close(to_read);
    ::close(to_write);
    throw failure;
  }
  if (process == 0) {
    ::close(to_read);
    work_and_exit(work, memory_limit_mb, to_write);
  }
  ::close(to_write);
  std::string text = read_all(to_read);
  ::close(to_read);

  int status = 0;
  rusage usage{};
  while (::wait4(process, &status, 0, &usage) < 0)
    if (errno != EINTR) throw no_process();
  ProcessReport report = report_of(status, std::move(text));
  report.peak_mb = static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
  return report;
}

}  // namespace oplus
