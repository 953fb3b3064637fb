// SPDX-License-Identifier: MIT
// Queries: components, areas, locations, and a sum that is summed again.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto islands = oplus::read_wkt("MULTIPOLYGON(((0 0,1 0,1 1,0 1,0 0)),((4 0,5 0,5 1,4 1,4 0)))");
  auto tool = oplus::polygon({{0, 0}, {"1/3", 0}, {0, "1/3"}});
  oplus::ValidSet once = minkowski_sum(islands, tool);
  oplus::ValidSet twice = minkowski_sum(once.region(), tool);

  for (const oplus::Component& component : twice.components())
    std::cout << component.outer.size() << " vertices, " << component.holes.size() << " holes\n";
  std::cout << "areas " << area(islands) << ' ' << area(once) << ' ' << area(twice) << '\n';

  for (const oplus::Coordinates& point : {oplus::Coordinates(1, 1), {"5/3", 0}, {2, 0}}) {
    const oplus::Location location = locate(point, twice);
    std::cout << (location == oplus::Location::inside     ? "inside"
                  : location == oplus::Location::boundary ? "boundary"
                                                          : "outside")
              << (contains(twice, point) ? ", in the sum" : "")
              << (contains(islands, point) ? ", on an island" : "")
              << (locate(point, islands) == oplus::Location::boundary ? ", at its boundary" : "")
              << '\n';
  }

  // Out of exact numbers: the nearest doubles.
  const auto [x, y] = to_double(twice.components()[0].outer[1]);
  std::cout << x << ' ' << y << ' ' << oplus::to_double(area(once)) << '\n';
}
