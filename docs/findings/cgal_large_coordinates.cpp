// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle with coordinates of 10^108, exact, and itself.
// Expected: signal 11
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/minkowski_sum_2.h>
using K = CGAL::Exact_predicates_exact_constructions_kernel;
int main() {
  std::istringstream digits("1" + std::string(108, '0'));
  K::FT::ET c;
  digits >> c;
  CGAL::Polygon_2<K> p;
  for (auto [x, y] : {std::pair{1, 2}, {0, 0}, {1, 1}}) p.push_back({K::FT(c) * x, K::FT(c) * y});
  std::cout << CGAL::minkowski_sum_by_reduced_convolution_2(p, p).number_of_holes() << " holes\n";
}
