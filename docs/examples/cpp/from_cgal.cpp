// SPDX-License-Identifier: MIT
// Where a slider meets a frame, by CGAL and by oplus.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/minkowski_sum_2.h>

#include <iostream>
#include <oplus/cgal.hpp>
#include <oplus/oplus.hpp>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using Point = Kernel::Point_2;

int main() {
  const std::vector<Point> outer = {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
                           inner = {{1, 1}, {1, 3}, {3, 3}, {3, 1}},
                           reflected = {{0, 0}, {-2, 0}, {-2, -1}, {0, -1}};
  PolygonWithHoles frame(Polygon(outer.begin(), outer.end()));
  frame.add_hole(Polygon(inner.begin(), inner.end()));
  const Polygon slider(reflected.begin(), reflected.end());

  const PolygonWithHoles by_cgal = CGAL::minkowski_sum_2(frame, slider);

  const oplus::ValidRegion p = oplus::from_cgal(frame), q = oplus::from_cgal(slider);
  const oplus::ValidSet closed = minkowski_sum(p, q);
  const oplus::ValidSet open = minkowski_sum(p, q, {.boundary = oplus::Boundary::open});

  std::cout << "the same area: " << (area(oplus::from_cgal(by_cgal)) == area(closed)) << '\n'
            << "vertices: " << by_cgal.outer_boundary().size() << " by CGAL, "
            << closed.components()[0].outer.size() << " by oplus\n"
            << "holes: " << by_cgal.number_of_holes() << '\n';
  for (const oplus::Segment& edge : open.dangling_edges())
    std::cout << "the slider fits from " << edge.source.x << ' ' << edge.source.y << " to "
              << edge.target.x << ' ' << edge.target.y << '\n';
}
