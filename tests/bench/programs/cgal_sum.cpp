// SPDX-License-Identifier: GPL-3.0-or-later
// cgal-sum P Q S: what a user of CGAL writes to sum two polygons without holes. P and Q are .dat files of
// one chain each; S becomes one.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <fstream>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;

static Polygon read(const char* path) {
  std::ifstream in(path);
  std::size_t size = 0;
  in >> size;
  Polygon polygon;
  for (double x = 0, y = 0; size > 0 && in >> x >> y; --size) polygon.push_back({x, y});
  return polygon;
}

static void write(std::ostream& out, const Polygon& polygon) {
  out << polygon.size() << '\n';
  for (const Kernel::Point_2& p : polygon)
    out << CGAL::exact(p.x()) << ' ' << CGAL::exact(p.y()) << '\n';
}

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const CGAL::Polygon_with_holes_2<Kernel> sum =
      CGAL::minkowski_sum_by_reduced_convolution_2(read(argv[1]), read(argv[2]));
  std::ofstream out(argv[3]);
  write(out, sum.outer_boundary());
  out << sum.number_of_holes() << '\n';
  for (const Polygon& hole : sum.holes()) write(out, hole);
  return out.flush() ? 0 : 2;
}
