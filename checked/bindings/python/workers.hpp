// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>
#include <oplus/oplus.hpp>

namespace oplus::python {

namespace py = pybind11;

/// Returns options for one sum. Ten times a second it takes Python's lock, so that Ctrl-C raises KeyboardInterrupt, and
/// calls progress(done, total) unless that is None. Throws std::invalid_argument for threads
/// below 0 and above 1024.
///
/// Requires: the caller keeps `progress` as long as the options are used.
SumOptions options_of(long long threads, py::handle progress);

/// Calls `work` once with each number below n, on this thread and on threads - 1 others; 0: as many as there
/// are cores; less where no more can be started. Ctrl-C ends it between two calls, by py::error_already_set; an
/// exception of `work` or of `progress` ends it too, and is thrown. Throws as options_of.
///
/// Requires: the caller holds Python's lock. It is released meanwhile, so `work` may use nothing of Python.
void for_each_below(std::size_t n, long long threads, py::handle progress,
                    const std::function<void(std::size_t)>& work);

}  // namespace oplus::python
