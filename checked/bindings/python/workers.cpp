// SPDX-License-Identifier: MIT
#include "checked/bindings/python/workers.hpp"

#include <pybind11/pybind11.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "checked/bindings/python/unlocked.hpp"

namespace oplus::python {

namespace py = pybind11;

namespace {

/// Only there signals are handled; another thread may not take the lock once Python ends.
bool is_main_thread() {
  const auto threading = py::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

void throw_if_interrupted() {
  const py::gil_scoped_acquire acquired;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace

unsigned checked_threads(long long threads) {
  if (threads < 0 || threads > 1024)
    throw std::invalid_argument("threads " + std::to_string(threads) + "; expected 0 to 1024");
  return static_cast<unsigned>(threads);
}

void for_each_below(std::size_t n, long long wanted, const std::function<void(std::size_t)>& work) {
  using Clock = std::chrono::steady_clock;
  unsigned threads = checked_threads(wanted);
  const bool is_main = is_main_thread();
  const Unlocked released;
  std::atomic<std::size_t> next{0};
  std::atomic<bool> is_stopped{false};
  std::exception_ptr failure;
  std::mutex of_failure;
  const auto run = [&](bool looks) {
    Clock::time_point last_look = Clock::now();
    try {
      for (std::size_t i = next++; i < n && !is_stopped; i = next++) {
        work(i);
        if (looks && Clock::now() - last_look > std::chrono::milliseconds(50)) {
          throw_if_interrupted();
          last_look = Clock::now();
        }
      }
    } catch (...) {
      is_stopped = true;
      const std::lock_guard lock(of_failure);
      if (!failure) failure = std::current_exception();
    }
  };
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  threads = static_cast<unsigned>(std::min<std::size_t>(threads, std::max<std::size_t>(n, 1)));
  {
    std::vector<std::jthread> others;
    try {
      for (unsigned i = 1; i < threads; ++i) others.emplace_back(run, false);
    } catch (const std::system_error&) {
      // Those that were started do all of it.
    }
    run(is_main);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace oplus::python
