// SPDX-License-Identifier: MIT
#include "checked/slide/parallel_for.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <vector>

#include "checked/joined_thread.hpp"

namespace oplus::slide {

void parallel_for(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto run = [&] {
    try {
      for (std::size_t i = next++; i < n; i = next++) work(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
      next = n;
    }
  };
  {
    std::vector<JoinedThread> others;
    try {
      others.reserve(std::min<std::size_t>(threads, n));
      while (others.size() + 1 < std::min<std::size_t>(threads, n)) others.emplace_back(run);
    } catch (const std::system_error&) {
      // As many as the system has; none in WebAssembly.
    }
    run();
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace oplus::slide
