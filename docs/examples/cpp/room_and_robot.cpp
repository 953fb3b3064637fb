// SPDX-License-Identifier: MIT
// How a robot's places are blocked: README's program.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto room = oplus::read_wkt("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))");
  auto robot = oplus::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  auto blocked = oplus::minkowski_sum(room, -robot);
  std::cout << to_wkt(blocked) << "\narea " << area(blocked) << '\n';
}
