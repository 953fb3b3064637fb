// SPDX-License-Identifier: MIT
// A sum with a vertex between integers, by Clipper and by oplus.
#include <iostream>
#include <oplus/oplus.hpp>
#include <polyclipping/clipper.hpp>

int main() {
  const ClipperLib::Path p = {{0, 100}, {0, 0}, {100, 0}};
  const ClipperLib::Paths q = {{{200, -100}, {0, 100}, {-100, -100}, {0, 0}}};
  ClipperLib::Paths by_clipper;
  ClipperLib::MinkowskiSum(p, q, by_clipper, true);
  for (const ClipperLib::IntPoint& v : by_clipper.at(0)) std::cout << v.X << ' ' << v.Y << '\n';

  // Any type with two coordinates is a point, and text is a number.
  const oplus::ValidRegion triangle = oplus::polygon({{0, 1}, {0, 0}, {1, 0}}),
                           arrow = oplus::polygon({{2, -1}, {0, 1}, {-1, -1}, {0, 0}});
  const oplus::ValidSet sum = minkowski_sum(triangle, arrow);
  std::cout << to_wkt(sum) << '\n';

  // Rounded to hundredths, to a set that contains the sum.
  const oplus::Rounded rounded = oplus::rounded(sum, "1/100", oplus::Side::contain);
  std::cout << to_wkt(rounded.sum) << '\n';
}
