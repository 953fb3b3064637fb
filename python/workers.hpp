// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace oplus::python {

/// Calls `work` once with each number below n, on this thread and on threads - 1 others; 0: as many as there
/// are cores. Ctrl-C ends it between two calls, by py::error_already_set; an exception of `work` ends it too, and
/// is thrown.
///
/// Requires: the caller holds Python's lock. It is released meanwhile, so `work` may use nothing of Python.
void for_each_below(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace oplus::python
