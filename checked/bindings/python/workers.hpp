// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace oplus::python {

/// Returns the number of threads. Throws std::invalid_argument below 0 and above 1024.
unsigned checked_threads(long long threads);

/// Calls `work` once with each number below n, on this thread and on threads - 1 others; 0: as many as there
/// are cores; less where no more can be started. Ctrl-C ends it between two calls, by py::error_already_set; an
/// exception of `work` ends it too, and is thrown. Throws as checked_threads.
///
/// Requires: the caller holds Python's lock. It is released meanwhile, so `work` may use nothing of Python.
void for_each_below(std::size_t n, long long threads, const std::function<void(std::size_t)>& work);

}  // namespace oplus::python
