// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/for_each_number.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace oplus::slide {

void for_each_number(std::size_t n, unsigned threads,
                     const std::function<void(std::size_t)>& work) {
  if (threads <= 1) {
    for (std::size_t i = 0; i < n; ++i) work(i);
    return;
  }
  // As many as are asked for, whatever the machine has.
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, n, work); });
}

}  // namespace oplus::slide
