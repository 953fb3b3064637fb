// SPDX-License-Identifier: MIT
#include "checked/bindings/python/workers.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "checked/bindings/python/unlocked.hpp"
#include "checked/slide/parallel_for.hpp"

namespace oplus::python {

namespace {

using Clock = std::chrono::steady_clock;

/// Only there signals are handled; another thread may not take the lock once Python ends.
bool is_main_thread() {
  const auto threading = py::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

/// Throws py::error_already_set for Ctrl-C and what `progress` raises, if it is not None.
void report(py::handle progress, std::size_t done, std::size_t total) {
  const py::gil_scoped_acquire locked;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (!progress.is_none()) progress(done, total);
}

unsigned checked_threads(long long threads) {
  if (threads < 0 || threads > 1024)
    throw std::invalid_argument("threads " + std::to_string(threads) + "; expected 0 to 1024");
  return static_cast<unsigned>(threads);
}

}  // namespace

SumOptions options_of(long long threads, py::handle progress) {
  SumOptions options{.threads = checked_threads(threads)};
  const auto next = std::make_shared<std::atomic<Clock::rep>>();
  options.progress = [progress, next](std::size_t done, std::size_t total) {
    const auto now = Clock::now().time_since_epoch().count();
    auto expected = next->load();
    constexpr auto pause = Clock::duration(std::chrono::milliseconds(100)).count();
    if (now >= expected && next->compare_exchange_strong(expected, now + pause))
      report(progress, done, total);
  };
  return options;
}

void for_each_below(std::size_t n, long long wanted, py::handle progress,
                    const std::function<void(std::size_t)>& work) {
  unsigned threads = checked_threads(wanted);
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  const bool is_reporting = !progress.is_none() || is_main_thread();
  const std::thread::id caller = std::this_thread::get_id();
  Clock::time_point last_look = Clock::now();
  std::atomic<std::size_t> done = 0;
  const Unlocked released;
  slide::parallel_for(n, threads, [&](std::size_t i) {
    work(i);
    ++done;
    if (!is_reporting || std::this_thread::get_id() != caller) return;
    if (Clock::now() - last_look < std::chrono::milliseconds(50)) return;
    report(progress, done, n);
    last_look = Clock::now();
  });
}

}  // namespace oplus::python
