// SPDX-License-Identifier: GPL-3.0-or-later
// Two simple polygons of 4 and 5 vertices.
// Expected: signal 11
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/minkowski_sum_2.h>
using K = CGAL::Exact_predicates_exact_constructions_kernel;
int main() {
  CGAL::Polygon_2<K> p, q;
  for (auto [x, y] : {std::pair{0, 0}, {0, -1}, {-1, 0}, {1, -3}}) p.push_back({x, y});
  for (auto [x, y] : {std::pair{1, -1}, {0, 0}, {0, 1}, {0, 2}, {-1, 0}}) q.push_back({x, y});
  std::cout << CGAL::minkowski_sum_by_full_convolution_2(p, q) << '\n';
}
