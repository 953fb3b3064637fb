// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "tests/bench/engine.hpp"

namespace oplus {

const std::vector<BenchmarkedEngine>& benchmarked_engines() {
  constexpr Arithmetic exact = Arithmetic::exact;
  constexpr Arithmetic rounding = Arithmetic::rounding;
  static const std::vector<BenchmarkedEngine> all{
      {"slide", "oplus: the reduced convolution, whose segments are covered by what blocks them",
       exact, true, prepare_slide},
      {"slide2", "oplus: slide on two threads", exact, true, prepare_slide_on_two_threads},
      {"rca", "oplus: faces of the reduced convolution's arrangement, a hole test each", exact,
       true, prepare_rca},
      {"winding", "oplus: winding numbers on the full convolution's arrangement", exact, true,
       prepare_winding},
      {"cgal-reduced", "CGAL: minkowski_sum_by_reduced_convolution_2", exact, false,
       prepare_cgal_reduced},
      {"cgal-full", "CGAL: minkowski_sum_by_full_convolution_2", exact, false, prepare_cgal_full},
      {"cgal-vertical",
       "CGAL: minkowski_sum_by_decomposition_2 with Polygon_vertical_decomposition_2", exact, false,
       prepare_cgal_vertical},
      {"clipper", "Clipper 6: MinkowskiSum, filled by the summand into which the other may fit",
       rounding, false, prepare_clipper},
      {"boost-polygon", "Boost.Polygon: its Minkowski example, then the polygon set's union",
       rounding, false, prepare_boost_polygon},
      {"traced", "oplus: the convolution by cycle tracing", exact, true,
       prepare_traced_convolution},
      {"naive", "oplus: the convolution from all pairs of a vertex and an edge", exact, true,
       prepare_naive_convolution},
      {"crash", "aborts", exact, false, prepare_crash},
      {"hang", "never ends", exact, false, prepare_hang},
      {"wrong", "moves a vertex of the sum", exact, false, prepare_wrong},
  };
  return all;
}

const BenchmarkedEngine* find_benchmarked_engine(const std::string& name) {
  const std::vector<BenchmarkedEngine>& all = benchmarked_engines();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const BenchmarkedEngine& e) { return e.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace oplus
