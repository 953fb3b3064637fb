// SPDX-License-Identifier: MIT
// Many sums of one region: what depends on it alone is computed once.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto bin = oplus::read_wkt("POLYGON((0 0,9 0,9 9,0 9,0 0),(1 1,1 8,8 8,8 1,1 1))");
  const oplus::PreparedRegion prepared(bin);
  for (int width = 1; width <= 3; ++width) {
    auto part = oplus::polygon({{0, 0}, {width, 0}, {width, 1}, {0, 1}});
    auto no_fit = minkowski_sum(prepared, -part);
    std::cout << area(no_fit) << ' ' << (no_fit == minkowski_sum(prepared.region(), -part)) << '\n';
  }
}
