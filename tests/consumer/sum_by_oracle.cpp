// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <oplus/reference/oracle/oracle.hpp>

/// A frame, 4 by 4 with a hole of 2 by 2, and a unit square: 5 by 5 with a hole of 1 by 1.
int main() {
  oplus::Region frame = oplus::polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  frame.components[0].holes = {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}};
  const oplus::Region square = oplus::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const oplus::MinkowskiSum sum = oplus::oracle_sum(frame, square, oplus::Boundary::closed);
  const std::vector<oplus::Chain> hole = {{{2, 2}, {2, 3}, {3, 3}, {3, 2}}};
  const bool right = sum.outer.size() == 1 && sum.holes == hole && oplus::area(sum) == 24;
  std::cout << "area " << oplus::area(sum) << (right ? "\n" : ", which is wrong\n");
  return right ? 0 : 1;
}
