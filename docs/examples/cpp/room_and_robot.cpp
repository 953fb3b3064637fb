// SPDX-License-Identifier: MIT
// How a robot's places are blocked: README's program.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto room = oplus::read_wkt("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))");
  auto robot = oplus::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  auto blocked = oplus::minkowski_sum(room, -robot);
  for (const auto& part : blocked.components())
    std::cout << part.outer.size() << " vertices, " << part.holes.size() << " hole\n";
  std::cout << to_wkt(blocked) << "\narea " << area(blocked)
            << (contains(blocked, {2, 2}) ? ", blocked" : ", free") << " at (2, 2)\n";
}
