// SPDX-License-Identifier: MIT
#include "checked/bindings/python/workers.hpp"

#include <pybind11/pybind11.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include "checked/bindings/python/unlocked.hpp"
#include "checked/slide/parallel_for.hpp"

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
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  const bool is_main = is_main_thread();
  const std::thread::id caller = std::this_thread::get_id();
  Clock::time_point last_look = Clock::now();
  const Unlocked released;
  slide::parallel_for(n, threads, [&](std::size_t i) {
    work(i);
    if (!is_main || std::this_thread::get_id() != caller) return;
    if (Clock::now() - last_look < std::chrono::milliseconds(50)) return;
    throw_if_interrupted();
    last_look = Clock::now();
  });
}

}  // namespace oplus::python
