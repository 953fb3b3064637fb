// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/own_process.hpp"

#include <gmp.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>

#include "properties/compare/peers/method.hpp"
#include "tests/bench/numbers.hpp"
#include "tests/bench/report.hpp"

namespace oplus {

namespace {

using Ending = Measurement::Ending;

constexpr int exit_out_of_memory = 2;

[[noreturn]] void stop_out_of_memory() { ::_exit(exit_out_of_memory); }

void* or_out_of_memory(void* memory) {
  if (memory == nullptr) stop_out_of_memory();
  return memory;
}

/// An allocation that fails ends the process at once. GMP would abort, which looks like a crash.
void stop_where_memory_ends() {
  std::set_new_handler(stop_out_of_memory);
  ::mp_set_memory_functions([](std::size_t size) { return or_out_of_memory(std::malloc(size)); },
                            [](void* old, std::size_t, std::size_t size) {
                              return or_out_of_memory(std::realloc(old, size));
                            },
                            [](void* memory, std::size_t) { std::free(memory); });
}

/// The work of the forked process. Returns its exit code.
int measure(const Measuring& work, int output) {
  Measurement measurement;
  try {
    stop_where_memory_ends();
    // An empty line shows that it is alive. At most one in 20 ms, so that writing costs no time.
    auto last = std::chrono::steady_clock::time_point();
    measurement = work([&] {
      const auto now = std::chrono::steady_clock::now();
      if (now - last < std::chrono::milliseconds(20)) return;
      ::dprintf(output, "\n");
      last = now;
    });
  } catch (const std::bad_alloc&) {
    return exit_out_of_memory;
  } catch (const Unsupported& e) {
    measurement = {.outcome = Ending::unsupported, .note = e.what()};
  } catch (const std::exception& e) {
    measurement = {.outcome = Ending::failed, .note = e.what()};
  } catch (...) {
    measurement = {.outcome = Ending::failed, .note = "unknown exception"};
  }
  ::dprintf(output, "%s\n", to_json(measurement).c_str());
  return 0;
}

Measurement measurement_from(const EndedProcess& ended, double limit) {
  switch (ended.how) {
    case EndedProcess::How::over_time:
    case EndedProcess::How::over_output:
      return {.outcome = Ending::over_limit, .note = "> " + plain(limit) + " s"};
    case EndedProcess::How::killed_by_signal:
      return {.outcome = Ending::crashed, .note = "signal " + std::to_string(ended.code)};
    case EndedProcess::How::interrupted:  // only where limits.is_interrupted is set
    case EndedProcess::How::exited:
      break;
  }
  if (ended.code == exit_out_of_memory) return {.outcome = Ending::out_of_memory};
  try {
    const std::size_t last = ended.output.find_last_not_of('\n');
    const std::size_t begin = ended.output.rfind('\n', last);
    return measurement_of(ended.output.substr(begin + 1));
  } catch (const std::invalid_argument&) {
    return {.outcome = Ending::failed, .note = "exit code " + std::to_string(ended.code)};
  }
}

}  // namespace

Measurement measured_in_own_process(const Measuring& work, ProcessLimits limits) {
  limits.a_line_at_a_time = true;
  const EndedProcess ended = run_fork([&](int output) { return measure(work, output); }, limits);
  Measurement measurement = measurement_from(ended, limits.seconds);
  measurement.numbers.emplace("peak_mb", ended.peak_mb);
  return measurement;
}

}  // namespace oplus
