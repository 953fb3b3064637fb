// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/peer_table.hpp"

#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/version.h>

#include <boost/version.hpp>
#include <sstream>

#include "properties/compare/peers/boost_polygon_method.hpp"
#include "properties/compare/peers/cgal_methods.hpp"
#include "properties/compare/peers/clipper_method.hpp"
#ifdef OPLUS_CLIPPER2
#include "properties/compare/peers/clipper2_method.hpp"
#endif

namespace oplus {

namespace {

using Kernel = CgalMethod::Kernel;

template <typename Method>
ReturnedChains sum_by(const Summands& pair) {
  const Method method;
  const typename Method::Input input = method.converted(pair);
  return method.chains(input, method.sum(input));
}

void write_line(const ReturnedChains& chains, std::ostream& out) {
  for (const Chain& chain : chains) {
    char command = 'M';
    for (const auto& [x, y] : chain) {
      out << command << x << ' ' << y;
      command = 'L';
    }
    out << 'Z';
  }
  out << '\n';
}

template <typename Method>
void write_no_fit_polygons(const std::vector<Region>& parts, std::ostream& out) {
  const Method method;
  std::vector<Region> both = parts;
  for (const Region& part : parts) both.push_back(reflected(part));
  const IntegerScale scale = Method::scale_of(both);
  std::vector<typename Method::Part> converted;
  for (const Region& region : both) converted.push_back(method.part(region, scale));
  out << scale.factor << '\n';
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t q = parts.size(); q < both.size(); ++q) {
      const typename Method::Input pair = method.paired(converted[p], converted[q]);
      write_line(method.chains(pair, method.sum(pair)), out);
    }
}

template <typename Method>
Peer peer() {
  return {sum_by<Method>, write_no_fit_polygons<Method>};
}

}  // namespace

Peer cgal_reduced() { return peer<CgalReduced>(); }
Peer cgal_full() { return peer<CgalFull>(); }
Peer cgal_vertical() { return peer<CgalVertical>(); }
Peer cgal_triangulation() {
  return peer<CgalDecomposingHoles<CGAL::Polygon_triangulation_decomposition_2<Kernel>>>();
}
Peer cgal_small_side() {
  return peer<CgalDecomposing<CGAL::Small_side_angle_bisector_decomposition_2<Kernel>>>();
}
Peer cgal_optimal() {
  return peer<CgalDecomposing<CGAL::Optimal_convex_decomposition_2<Kernel>>>();
}
Peer cgal_hertel_mehlhorn() {
  return peer<CgalDecomposing<CGAL::Hertel_Mehlhorn_convex_decomposition_2<Kernel>>>();
}
Peer cgal_greene() { return peer<CgalDecomposing<CGAL::Greene_convex_decomposition_2<Kernel>>>(); }
Peer clipper() { return peer<ClipperMethod>(); }
#ifdef OPLUS_CLIPPER2
Peer clipper2() { return peer<Clipper2Method>(); }
#endif
Peer boost_polygon() { return peer<BoostPolygonMethod>(); }

std::string libraries_of_peers() {
  std::ostringstream text;
  text << "CGAL " << CGAL_VERSION_STR << ", Clipper " << CLIPPER_VERSION;
#ifdef OPLUS_CLIPPER2
  text << ", Clipper2 " << CLIPPER2_VERSION;
#endif
  text << ", Boost " << BOOST_VERSION / 100000 << '.' << BOOST_VERSION / 100 % 1000 << '.'
       << BOOST_VERSION % 100 << "; GCC " << __VERSION__;
  return text.str();
}

}  // namespace oplus
