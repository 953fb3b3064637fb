// SPDX-License-Identifier: MIT
// Output as WKT and GeoJSON: exact, or rounded.
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

  // What is exact is read again as it was; what is rounded may be invalid.
  std::cout << (oplus::read_wkt(to_wkt(sum)) == sum.region()) << '\n';
  try {
    oplus::read_wkt(to_wkt(triangle, 0));
  } catch (const oplus::InvalidInput& error) {
    std::cout << error.what() << '\n';
  }
}
