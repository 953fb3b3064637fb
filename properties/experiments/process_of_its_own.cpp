// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/process_of_its_own.hpp"

#include <gmp.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <utility>

#include "properties/runner/child_process.hpp"

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
void stop_where_memory_ends() {
  std::set_new_handler(stop_out_of_memory);
  ::mp_set_memory_functions([](std::size_t size) { return or_out_of_memory(std::malloc(size)); },
                            [](void* old, std::size_t, std::size_t size) {
                              return or_out_of_memory(std::realloc(old, size));
                            },
                            [](void* memory, std::size_t) { std::free(memory); });
}

void write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(file, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) return;
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

/// What the forked process does. Returns its exit code.
int exit_code_of(const std::function<std::string()>& work, int result) {
  try {
    stop_where_memory_ends();
    write_all(result, work());
    return exit_done;
  } catch (const std::bad_alloc&) {
    return exit_out_of_memory;
  } catch (const std::exception& e) {
    write_all(result, e.what());
    return exit_threw;
  } catch (...) {
    return exit_threw;
  }
}

ProcessReport report_of(EndedProcess ended) {
  using Kind = ProcessReport::Kind;
  if (ended.how == EndedProcess::How::killed_by_signal)
    return {Kind::failed,
            "killed by signal " + std::to_string(ended.code) + ", " + ::strsignal(ended.code),
            ended.peak_mb};
  switch (ended.code) {
    case exit_done:
      return {Kind::done, std::move(ended.output), ended.peak_mb};
    case exit_out_of_memory:
      return {Kind::out_of_memory, "out of memory", ended.peak_mb};
    default:
      return {Kind::failed, "threw: " + ended.output, ended.peak_mb};
  }
}

}  // namespace

ProcessReport in_process_of_its_own(const std::function<std::string()>& work,
                                    std::size_t memory_limit_mb) {
  ProcessLimits limits;
#ifndef __SANITIZE_ADDRESS__
  limits.address_space_mb = memory_limit_mb;
#else
  static_cast<void>(memory_limit_mb);
#endif
  return report_of(run_fork([&](int result) { return exit_code_of(work, result); }, limits));
}

}  // namespace oplus
