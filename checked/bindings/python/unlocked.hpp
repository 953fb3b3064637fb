// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
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

}  // namespace oplus::python
