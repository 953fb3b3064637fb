// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>

#include "properties/compare/peers/cgal_methods.hpp"
#include "properties/compare/peers/returned_chains.hpp"

namespace oplus {

namespace {

using Kernel = CgalMethod::Kernel;

template <typename Decomposition>
CgalMethod::Sum sum_of_simple(const CgalMethod::Input& pair) {
  return CGAL::minkowski_sum_by_decomposition_2(pair.p.outer_boundary(), pair.q.outer_boundary(),
                                                Decomposition());
}

template <typename Decomposition>
CgalMethod::Sum sum_of_any(const CgalMethod::Input& pair) {
  if (pair.is_simple()) return sum_of_simple<Decomposition>(pair);
  const Decomposition decomposition;
  return CGAL::minkowski_sum_by_decomposition_2(pair.p, pair.q, decomposition, decomposition);
}

}  // namespace

CgalMethod::Sum CgalVertical::sum(const Input& pair) const {
  return sum_of_any<CGAL::Polygon_vertical_decomposition_2<Kernel>>(pair);
}

CgalMethod::Sum CgalTriangulation::sum(const Input& pair) const {
  return sum_of_any<CGAL::Polygon_triangulation_decomposition_2<Kernel>>(pair);
}

CgalMethod::Sum CgalSmallSide::sum(const Input& pair) const {
  return sum_of_simple<CGAL::Small_side_angle_bisector_decomposition_2<Kernel>>(pair);
}

CgalMethod::Sum CgalOptimal::sum(const Input& pair) const {
  return sum_of_simple<CGAL::Optimal_convex_decomposition_2<Kernel>>(pair);
}

CgalMethod::Sum CgalHertelMehlhorn::sum(const Input& pair) const {
  return sum_of_simple<CGAL::Hertel_Mehlhorn_convex_decomposition_2<Kernel>>(pair);
}

CgalMethod::Sum CgalGreene::sum(const Input& pair) const {
  return sum_of_simple<CGAL::Greene_convex_decomposition_2<Kernel>>(pair);
}

ReturnedChains cgal_vertical(const Summands& pair) { return returned_chains<CgalVertical>(pair); }
ReturnedChains cgal_triangulation(const Summands& pair) {
  return returned_chains<CgalTriangulation>(pair);
}
ReturnedChains cgal_small_side(const Summands& pair) {
  return returned_chains<CgalSmallSide>(pair);
}
ReturnedChains cgal_optimal(const Summands& pair) { return returned_chains<CgalOptimal>(pair); }
ReturnedChains cgal_hertel_mehlhorn(const Summands& pair) {
  return returned_chains<CgalHertelMehlhorn>(pair);
}
ReturnedChains cgal_greene(const Summands& pair) { return returned_chains<CgalGreene>(pair); }

}  // namespace oplus
