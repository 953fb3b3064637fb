// SPDX-License-Identifier: GPL-3.0-or-later
// The input of CGAL's issue 8551, with assertions: a segment and a polygon.
// Expected: signal 6
#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/minkowski_sum_2.h>
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
int main() {
  CGAL::Polygon_2<K> p, q;
  for (auto [x, y] : {std::pair{824, 627}, {689, 555}}) p.push_back({x, y});
  for (auto [x, y] : {std::pair{130, 150}, {20, 40}, {50, 60}, {125, 100}}) q.push_back({x, y});
  std::cout << CGAL::minkowski_sum_by_full_convolution_2(p, q) << '\n';
}
