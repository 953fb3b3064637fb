// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/ordered_work.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

namespace oplus {
namespace {

using Work = OrderedWork<int, int>;

/// Numbers below n, one after another.
auto numbers_below(int n) {
  return [n, next = 0]() mutable -> std::optional<int> {
    return next < n ? std::optional(next++) : std::nullopt;
  };
}

TEST(OrderedWork, passes_results_on_in_order) {
  for (const unsigned threads : {1U, 2U, 9U})
    for (const int n : {0, 1, 2, 1000}) {
      std::vector<int> passed_on;
      Work work({.take = numbers_below(n),
                 .work =
                     [](int&& i) {
                       // Some take longer.
                       if (i % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
                       return 2 * i;
                     },
                 .pass_on = [&](int&& done) { passed_on.push_back(done); }});
      work.run(threads, [] {});
      ASSERT_EQ(passed_on.size(), static_cast<std::size_t>(n));
      for (int i = 0; i < n; ++i) EXPECT_EQ(passed_on[static_cast<std::size_t>(i)], 2 * i);
    }
}

TEST(OrderedWork, does_not_run_ahead_of_a_lot_that_takes_long) {
  std::atomic<int> largest = 0;
  std::atomic<int> calls = 0;
  constexpr unsigned threads = 2;
  Work work({.take = numbers_below(10000),
             .work =
                 [&](int&& i) {
                   largest = std::max<int>(largest, i);
                   if (i > 0) return i;
                   // Until nobody takes any more.
                   for (int before = -1; before != largest;) {
                     before = largest;
                     std::this_thread::sleep_for(std::chrono::milliseconds(100));
                   }
                   EXPECT_LE(largest, 16 * static_cast<int>(threads));
                   return i;
                 },
             .pass_on = [&](int&&) { ++calls; }});
  work.run(threads, [] {});
  EXPECT_EQ(calls, 10000);
}

TEST(OrderedWork, throws_what_a_step_throws) {
  const auto fail_at = [](int where) {
    return [=](int&& i) {
      if (i == where) throw std::runtime_error("at " + std::to_string(i));
      return i;
    };
  };
  for (const unsigned threads : {1U, 3U}) {
    std::vector<int> passed_on;
    Work fails({.take = numbers_below(1000), .work = fail_at(500), .pass_on = [&](int&& i) {
                  passed_on.push_back(i);
                }});
    EXPECT_THROW(fails.run(threads, [] {}), std::runtime_error);
    EXPECT_LE(passed_on.size(), 500U);
    EXPECT_TRUE(std::is_sorted(passed_on.begin(), passed_on.end()));
    Work cannot_write({.take = numbers_below(1000), .work = fail_at(-1), .pass_on = [](int&&) {
                         throw std::runtime_error("full");
                       }});
    EXPECT_THROW(cannot_write.run(threads, [] {}), std::runtime_error);
    EXPECT_TRUE(cannot_write.is_stopping());
  }
}

TEST(OrderedWork, watches_while_it_works) {
  std::atomic<int> watched = 0;
  Work work({.take = numbers_below(1),
             .work =
                 [&](int&& i) {
                   while (watched < 2) std::this_thread::sleep_for(std::chrono::milliseconds(10));
                   return i;
                 },
             .pass_on = [](int&&) {}});
  work.run(1, [&] { ++watched; });
  EXPECT_GE(watched, 2);
}

}  // namespace
}  // namespace oplus
