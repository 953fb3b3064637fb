// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <oplus/oplus.hpp>
#include <thread>

/// @file
/// Work without Python's lock.
namespace oplus::python {

/// Python's lock is released as long as it lives. Where Python ends meanwhile, its thread stays: pybind11's would end
/// the program by std::terminate, as Python ends a thread that asks for the lock by an exception of the C library.
class Unlocked {
 public:
  Unlocked() : state_(PyEval_SaveThread()) {}
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;
  ~Unlocked() {
    try {
      PyEval_RestoreThread(state_);
    } catch (...) {
      while (true) std::this_thread::sleep_for(std::chrono::hours(1));
    }
  }

 private:
  PyThreadState* state_;
};

/// Returns work(), with Python's lock released meanwhile: it may use nothing of Python.
template <typename Work>
auto unlocked(const Work& work) {
  const Unlocked released;
  return work();
}

/// What a computation without the lock calls now and then: takes the lock, ten times a second, so that Ctrl-C raises
/// KeyboardInterrupt there. Throws py::error_already_set then.
class Interruptible {
 public:
  void operator()() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    auto next = next_->load();
    constexpr auto pause =
        std::chrono::steady_clock::duration(std::chrono::milliseconds(100)).count();
    if (now < next || !next_->compare_exchange_strong(next, now + pause)) return;
    const pybind11::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
  }

 private:
  std::shared_ptr<std::atomic<std::chrono::steady_clock::rep>> next_ =
      std::make_shared<std::atomic<std::chrono::steady_clock::rep>>();
};

/// The options, so that Ctrl-C ends the computation.
inline SumOptions interruptible(SumOptions options) {
  options.progress = [check = Interruptible()](auto...) mutable { check(); };
  return options;
}

}  // namespace oplus::python
