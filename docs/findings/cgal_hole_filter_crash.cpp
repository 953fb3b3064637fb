// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle with three triangular holes, the last two of them smaller than the triangle q.
// Expected: signal 6
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/minkowski_sum_2.h>
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<K>;
Polygon triangle(K::Point_2 a, K::Point_2 b, K::Point_2 c) {
  const K::Point_2 points[] = {a, b, c};
  return Polygon(points, points + 3);
}
int main() {
  const Polygon holes[] = {triangle({3, 1}, {3, 2}, {5, 1}), triangle({1, 1}, {1, 2}, {2, 1}),
                           triangle({1, 3}, {1, 4}, {2, 3})};
  const CGAL::Polygon_with_holes_2<K> p(triangle({0, 0}, {7, 0}, {0, 7}), holes, holes + 3);
  const Polygon q = triangle({0, 0}, {2, 0}, {0, 1});
  std::cout << CGAL::minkowski_sum_by_reduced_convolution_2(p, q).number_of_holes() << " holes\n";
}
