// SPDX-License-Identifier: GPL-3.0-or-later
// Scaled by 300: the vertex (2/3, -1/3) is the integer point (200, -100), and found. Scaled by 100 it
// is moved.
// Expected: (200, -100) (67, -33)
#include <iostream>
#include <polyclipping/clipper.hpp>
int main() {
  for (const int s : {300, 100}) {
    const ClipperLib::Path p{{0, s}, {0, 0}, {s, 0}};
    const ClipperLib::Paths q{{{2 * s, -s}, {0, s}, {-s, -s}, {0, 0}}};
    ClipperLib::Paths sum;
    ClipperLib::MinkowskiSum(p, q, sum, true);
    for (const auto& v : sum.at(0))
      if (2 * v.X > s && 2 * v.X < 2 * s)
        std::cout << (s == 300 ? "" : " ") << '(' << v.X << ", " << v.Y << ')';
  }
  std::cout << '\n';
}
