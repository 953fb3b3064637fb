// SPDX-License-Identifier: MIT
// Output as WKT, GeoJSON, WKB and .dat: exact, or rounded.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto triangle = oplus::polygon({{0, 0}, {1, 0}, {0.5, "1/3"}});
  auto sum = minkowski_sum(triangle, triangle);
  std::cout << to_wkt(triangle) << '\n'
            << to_wkt(sum) << '\n'
            << to_wkt(sum, 3) << '\n'
            << to_geojson(triangle) << '\n'
            << to_geojson(sum, 3) << '\n';

  // What is exact is read again as it was; what is rounded is valid, though it may be empty.
  std::cout << (oplus::read_wkt(to_wkt(sum)) == sum.region()) << ' ' << to_wkt(triangle, 0) << '\n';

  // To a grid, so that it contains the sum; the steps of WKB are powers of two.
  oplus::Rounded around = rounded(sum, 0.25, oplus::Side::contain);
  std::cout << to_wkt(around.sum) << ", within " << around.bound << " of it in x and in y, "
            << (around.changes == oplus::TopologyChanges{} ? "no hole" : "a hole")
            << " or component changed\n"
            << to_wkb(around.sum) << '\n';

  // Only .dat holds what is unbounded.
  std::cout << to_dat(complement(triangle));
}
