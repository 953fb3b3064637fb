// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle with a hole of four vertices, and a triangle: their sum has a hole.
// Expected: 0 holes
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/minkowski_sum_2.h>
using K = CGAL::Exact_predicates_exact_constructions_kernel;
int main() {
  CGAL::Polygon_2<K> outer, hole, q;
  for (auto [x, y] : {std::pair{-1, 4}, {-2, -3}, {2, -1}}) outer.push_back({x, y});
  for (auto [x, y] : {std::pair{0, 0}, {-2, -3}, {-1, 3}, {2, -1}}) hole.push_back({x, y});
  for (auto [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}}) q.push_back({x, y});
  const CGAL::Polygon_with_holes_2<K> p(outer, &hole, &hole + 1);
  std::cout << CGAL::minkowski_sum_by_reduced_convolution_2(p, q).number_of_holes() << " holes\n";
}
