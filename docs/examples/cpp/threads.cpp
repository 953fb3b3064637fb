// SPDX-License-Identifier: MIT
// Threads: a sum computed by many, and many sums at once.
#include <iostream>
#include <oplus/oplus.hpp>
#include <thread>

int main() {
  auto room = oplus::read_wkt("POLYGON((0 0,9 0,9 9,0 9,0 0),(1 1,1 8,8 8,8 1,1 1))");

  // By two threads; 0 means as many as there are cores. The sum is the same.
  auto robot = oplus::polygon({{0, 0}, {1, 0}, {0, 1}});
  auto by_two = minkowski_sum(room, -robot, {.threads = 2});
  std::cout << (by_two == minkowski_sum(room, -robot)) << '\n';

  // Nothing is shared between calls; regions and sums that don't change may be.
  std::vector<oplus::ValidSet> sums(3);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < sums.size(); ++i)
      threads.emplace_back([&sums, &room, i] {
        const auto size = i + 1;
        sums[i] = minkowski_sum(room, oplus::polygon({{0, 0}, {size, 0}, {0, size}}));
      });
  }
  for (const auto& sum : sums) std::cout << area(sum) << '\n';
}
