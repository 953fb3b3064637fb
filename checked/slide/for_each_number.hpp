// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace oplus::slide {

/// Calls work(0), ..., work(n - 1), on several threads if so many are asked for. What it throws is
/// thrown here.
void for_each_number(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& work);

}  // namespace oplus::slide
