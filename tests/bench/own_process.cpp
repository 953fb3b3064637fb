// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/own_process.hpp"

#include <gmp.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>

#include "properties/compare/peers/method.hpp"
#include "properties/runner/child_process.hpp"
#include "tests/bench/numbers.hpp"
#include "tests/bench/report.hpp"

namespace oplus {

namespace {

using Outcome = Measurement::Outcome;

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

void write_line(int file, std::string line) {
  line += '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = ::write(file, line.data() + done, line.size() - done);
    if (written < 0 && errno != EINTR) return;
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

/// Writes an empty line as a sign of life. Many in a short time are one, lest writing be what the
/// processor does.
class Pulse {
 public:
  explicit Pulse(int file) : file_(file) {}

  void beat() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(20)) return;
    write_line(file_, "");
    last_ = now;
  }

 private:
  int file_;
  std::chrono::steady_clock::time_point last_;
};

Measurement without_result(Outcome outcome, const std::string& note) {
  Measurement measurement;
  measurement.outcome = outcome;
  measurement.note = note;
  return measurement;
}

/// What the forked process does. Returns its exit code.
int measure(const Measuring& work, int output) {
  Measurement measurement;
  try {
    stop_where_memory_ends();
    Pulse pulse(output);
    measurement = work([&] { pulse.beat(); });
  } catch (const std::bad_alloc&) {
    return exit_out_of_memory;
  } catch (const NotTaken& e) {
    measurement = without_result(Outcome::not_taken, e.what());
  } catch (const std::exception& e) {
    measurement = without_result(Outcome::failed, e.what());
  } catch (...) {
    measurement = without_result(Outcome::failed, "threw no std::exception");
  }
  write_line(output, to_json(measurement));
  return 0;
}

Measurement measurement_from(const EndedProcess& ended, const MeasuringLimits& limits) {
  switch (ended.how) {
    case EndedProcess::How::over_time:
    case EndedProcess::How::over_output:
      return without_result(Outcome::over_limit, "> " + plain(limits.seconds) + " s");
    case EndedProcess::How::killed_by_signal:
      return without_result(Outcome::crashed, "signal " + std::to_string(ended.code));
    case EndedProcess::How::exited:
      break;
  }
  if (ended.code == exit_out_of_memory) return without_result(Outcome::out_of_memory, "");
  try {
    const std::size_t last = ended.output.find_last_not_of('\n');
    const std::size_t begin = ended.output.rfind('\n', last);
    return measurement_of(ended.output.substr(begin + 1));
  } catch (const std::invalid_argument&) {
    return without_result(Outcome::failed, "exit code " + std::to_string(ended.code));
  }
}

}  // namespace

Measurement measured_in_own_process(const Measuring& work, const MeasuringLimits& limits) {
  ProcessLimits of_process;
  of_process.seconds = limits.seconds;
  of_process.a_line_at_a_time = true;
  of_process.address_space_mb = limits.memory_mb;
  const EndedProcess ended =
      run_fork([&](int output) { return measure(work, output); }, of_process);
  Measurement measurement = measurement_from(ended, limits);
  measurement.numbers.emplace("peak_mb", ended.peak_mb);
  return measurement;
}

}  // namespace oplus
