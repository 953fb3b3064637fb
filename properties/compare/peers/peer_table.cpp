// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/peer_table.hpp"

#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>

#include "properties/compare/peers/boost_polygon_method.hpp"
#include "properties/compare/peers/cgal_methods.hpp"
#include "properties/compare/peers/clipper_method.hpp"

namespace oplus {

namespace {

using Kernel = CgalMethod::Kernel;

template <typename Method>
ReturnedChains chains_by(const Summands& pair) {
  const Method method;
  const typename Method::Input input = method.converted(pair);
  return method.chains(input, method.sum(input));
}

}  // namespace

ReturnedChains cgal_reduced(const Summands& pair) { return chains_by<CgalReduced>(pair); }
ReturnedChains cgal_full(const Summands& pair) { return chains_by<CgalFull>(pair); }
ReturnedChains cgal_vertical(const Summands& pair) { return chains_by<CgalVertical>(pair); }
ReturnedChains cgal_triangulation(const Summands& pair) {
  return chains_by<CgalDecomposingHoles<CGAL::Polygon_triangulation_decomposition_2<Kernel>>>(pair);
}
ReturnedChains cgal_small_side(const Summands& pair) {
  return chains_by<CgalDecomposing<CGAL::Small_side_angle_bisector_decomposition_2<Kernel>>>(pair);
}
ReturnedChains cgal_optimal(const Summands& pair) {
  return chains_by<CgalDecomposing<CGAL::Optimal_convex_decomposition_2<Kernel>>>(pair);
}
ReturnedChains cgal_hertel_mehlhorn(const Summands& pair) {
  return chains_by<CgalDecomposing<CGAL::Hertel_Mehlhorn_convex_decomposition_2<Kernel>>>(pair);
}
ReturnedChains cgal_greene(const Summands& pair) {
  return chains_by<CgalDecomposing<CGAL::Greene_convex_decomposition_2<Kernel>>>(pair);
}
ReturnedChains clipper(const Summands& pair) { return chains_by<ClipperMethod>(pair); }
ReturnedChains boost_polygon(const Summands& pair) { return chains_by<BoostPolygonMethod>(pair); }

}  // namespace oplus
