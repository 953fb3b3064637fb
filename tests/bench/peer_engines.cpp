// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/boost_polygon_method.hpp"
#include "properties/compare/peers/cgal_methods.hpp"
#include "properties/compare/peers/clipper_method.hpp"
#ifdef OPLUS_CLIPPER2
#include "properties/compare/peers/clipper2_method.hpp"
#endif
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
#ifdef OPLUS_CLIPPER2
  const std::string which = "-newest";
#else
  const std::string which;
#endif
  return {
      engine_of<CgalReduced>("cgal-reduced" + which, "minkowski_sum_by_reduced_convolution_2"),
      engine_of<CgalFull>("cgal-full" + which, "minkowski_sum_by_full_convolution_2"),
      engine_of<CgalVertical>(
          "cgal-vertical" + which,
          "minkowski_sum_by_decomposition_2 with Polygon_vertical_decomposition_2"),
#ifdef OPLUS_CLIPPER2
      engine_of<Clipper2Method>(
          "clipper2", "MinkowskiSum and Union with the larger summand, which fills the sum"),
#else
      engine_of<ClipperMethod>("clipper",
                               "MinkowskiSum, with the larger summand as its filled path"),
      engine_of<BoostPolygonMethod>("boost-polygon",
                                    "its Minkowski example, then the polygon set's union"),
#endif
  };
}

}  // namespace oplus
