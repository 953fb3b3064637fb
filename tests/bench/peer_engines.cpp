// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/boost_polygon_method.hpp"
#include "properties/compare/peers/cgal_methods.hpp"
#include "properties/compare/peers/clipper_method.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

template <typename Method>
struct Peer : Method {
  void describe(const typename Method::Input& input, const typename Method::Sum& sum,
                Description& description) const {
    description.add(this->chains(input, sum), Method::rounds);
  }
};

template <typename Method>
BenchEngine engine_of(const std::string& name, const std::string& what) {
  return {.name = name,
          .what = what,
          .prepare = each_pair([](const Row&) { return Peer<Method>(); }),
          .rounds = Method::rounds,
          .is_ours = false};
}

}  // namespace

std::vector<BenchEngine> peer_engines() {
  return {
      engine_of<CgalReduced>("cgal-reduced", "CGAL: minkowski_sum_by_reduced_convolution_2"),
      engine_of<CgalFull>("cgal-full", "CGAL: minkowski_sum_by_full_convolution_2"),
      engine_of<CgalVertical>(
          "cgal-vertical",
          "CGAL: minkowski_sum_by_decomposition_2 with Polygon_vertical_decomposition_2"),
      engine_of<ClipperMethod>(
          "clipper", "Clipper 6: MinkowskiSum, with the larger summand as its filled path"),
      engine_of<BoostPolygonMethod>(
          "boost-polygon", "Boost.Polygon: its Minkowski example, then the polygon set's union"),
  };
}

}  // namespace oplus
