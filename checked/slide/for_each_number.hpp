// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace oplus::slide {

/// Calls work(0), ..., work(n - 1), each once, on the calling thread and up to threads - 1 others, or as
/// many as can be started. Throws one of the exceptions that work throws; then some calls are left out.
void for_each_number(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace oplus::slide
