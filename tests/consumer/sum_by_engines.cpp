// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <oplus/checked/arrangement/rca.hpp>
#include <oplus/checked/slide/slide.hpp>

/// A unit square and a triangle: the sum's area is 1 + 1/2 + 2, the last one the mixed term.
int main() {
  const oplus::Region square = oplus::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const oplus::Region triangle = oplus::polygon({{0, 0}, {1, 0}, {0, 1}});
  const std::vector<oplus::Chain> expected = {{{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}}};
  bool right = true;
  for (const oplus::ComputedSum& result :
       {oplus::slide_sum(square, triangle, oplus::Boundary::closed, {.threads = 2}),
        oplus::rca(square, triangle, oplus::Boundary::closed)}) {
    right = right && result.sum.outer == expected && result.sum.holes.empty() &&
            oplus::area(result.sum) == oplus::Rational(7, 2);
    std::cout << "area " << oplus::area(result.sum) << '\n';
  }
  std::cout << (right ? "" : "which is wrong\n");
  return right ? 0 : 1;
}
