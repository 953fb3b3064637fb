// SPDX-License-Identifier: MIT
// To and from CGAL's polygons, of any kernel with rational numbers.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <iostream>
#include <oplus/cgal.hpp>
#include <oplus/oplus.hpp>

int main() {
  using Inexact = CGAL::Epick;  // coordinates are doubles
  CGAL::Polygon_2<Inexact> triangle;
  triangle.push_back({0, 0});
  triangle.push_back({0, 1});  // clockwise, which from_cgal allows
  triangle.push_back({1, 0});

  auto third = oplus::polygon({{0, 0}, {"1/3", 0}, {0, "1/3"}});
  oplus::ValidSet sum = minkowski_sum(oplus::from_cgal(triangle), third);

  using Exact = CGAL::Epeck;
  const std::vector<CGAL::Polygon_with_holes_2<Exact>> polygons = oplus::to_cgal<Exact>(sum);
  std::cout << polygons.size() << ' ' << polygons[0].outer_boundary().size() << ' '
            << CGAL::exact(polygons[0].outer_boundary().area()) << '\n';
  std::cout << (oplus::from_cgal(polygons) == sum.region()) << '\n';

  // Doubles cannot hold a third: each coordinate is rounded.
  std::cout << oplus::to_cgal<Inexact>(sum)[0].outer_boundary()[1] << '\n';
}
