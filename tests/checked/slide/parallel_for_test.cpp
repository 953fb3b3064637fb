// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/parallel_for.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace oplus::slide {
namespace {

TEST(ParallelFor, calls_once_for_each) {
  for (const unsigned threads : {0u, 1u, 2u, 8u, 4'000'000'000u}) {
    for (const std::size_t n : {0u, 1u, 2u, 7u, 1000u}) {
      std::vector<std::atomic<int>> calls(n);
      parallel_for(n, threads, [&](std::size_t i) { ++calls[i]; });
      for (const std::atomic<int>& for_one_engine : calls) ASSERT_EQ(for_one_engine, 1);
      if (threads > 8 && n > 2) break;
    }
  }
}

TEST(ParallelFor, uses_as_many_threads_as_asked_for) {
  std::mutex mutex;
  std::set<std::thread::id> ids;
  const auto started = [&] {
    const std::lock_guard lock(mutex);
    ids.insert(std::this_thread::get_id());
    return ids.size();
  };
  // Each waits for the others; not forever, to fail where they are missing.
  parallel_for(4, 4, [&](std::size_t) {
    for (int i = 0; i < 10'000 && started() < 4; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  EXPECT_EQ(ids.size(), 4u);
}

TEST(ParallelFor, throws_what_the_work_throws) {
  for (const unsigned threads : {1u, 4u}) {
    for (const std::size_t thrower : {0u, 500u, 999u}) {
      std::atomic<std::size_t> calls = 0;
      EXPECT_THROW(parallel_for(1000, threads,
                                [&](std::size_t i) {
                                  ++calls;
                                  if (i >= thrower) throw std::runtime_error("found");
                                }),
                   std::runtime_error);
      EXPECT_GE(calls, thrower + 1);
      EXPECT_LE(calls, thrower + threads) << "others go on to the end";
    }
  }
}

TEST(ParallelFor, needs_no_other_thread) {
  // Stacks as large as the whole address space: no thread can be started.
  pthread_attr_t before, large;
  pthread_getattr_default_np(&before);
  pthread_attr_init(&large);
  pthread_attr_setstacksize(&large, std::size_t{1} << 47);
  ASSERT_EQ(pthread_setattr_default_np(&large), 0);
  std::set<std::thread::id> ids;
  std::size_t calls = 0;
  parallel_for(100, 4, [&](std::size_t) {
    ++calls;
    ids.insert(std::this_thread::get_id());
  });
  pthread_setattr_default_np(&before);
  EXPECT_EQ(calls, 100u);
  EXPECT_EQ(ids, std::set{std::this_thread::get_id()});
}

TEST(ForEachPart, covers_all_in_parts_that_threads_do_not_change) {
  for (const std::size_t n : {0u, 1u, 9u, 10u, 11u, 1000u}) {
    std::set<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t first = 0; first < n; first += 10)
      expected.emplace(first, std::min(first + 10, n));
    for (const unsigned threads : {1u, 3u}) {
      std::mutex mutex;
      std::set<std::pair<std::size_t, std::size_t>> parts;
      for_each_part(
          n, threads,
          [&](std::size_t first, std::size_t last) {
            const std::lock_guard lock(mutex);
            EXPECT_TRUE(parts.emplace(first, last).second);
          },
          10);
      EXPECT_EQ(parts, expected) << n << ' ' << threads;
    }
  }
}

TEST(SortInParts, sorts) {
  for (const std::size_t n : {0u, 1u, 16'383u, 16'384u, 50'001u}) {
    std::vector<std::size_t> numbers(n);
    for (std::size_t i = 0; i < n; ++i) numbers[i] = (i * 7919) % 50'021;
    std::vector<std::size_t> expected = numbers;
    std::sort(expected.begin(), expected.end());
    for (const unsigned threads : {1u, 2u, 3u}) {
      std::vector<std::size_t> sorted = numbers;
      sort_in_parts(sorted, threads, std::less<>());
      EXPECT_EQ(sorted, expected) << n << ' ' << threads;
    }
  }
}

}  // namespace
}  // namespace oplus::slide
