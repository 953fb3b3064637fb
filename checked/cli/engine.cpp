// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/engine.hpp"

#include <algorithm>

#include "checked/arrangement/rca.hpp"
#include "checked/arrangement/sum_by_loops.hpp"
#include "checked/arrangement/sum_by_winding_numbers.hpp"
#include "checked/slide/slide.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Computed computed(ComputedSum result) {
  const RunStatistics& run = result.statistics;
  const auto seconds = [](Stages::Duration stage) { return std::to_string(stage.count()); };
  return {std::move(result.sum),
          std::move(result.origins),
          {{"segments in the arrangement", std::to_string(run.segments)},
           {"arrangement edges", std::to_string(run.arrangement_edges)},
           {"arrangement vertices", std::to_string(run.arrangement_vertices)},
           {"arrangement faces", std::to_string(run.arrangement_faces)},
           {"hole tests", std::to_string(run.hole_tests)},
           {"tests of low-dimensional features", std::to_string(run.point_tests)},
           {"seconds for cycles", seconds(run.stages.cycles)},
           {"seconds for the arrangement", seconds(run.stages.arrangement)},
           {"seconds to prepare hole tests", seconds(run.stages.hierarchy)},
           {"seconds for hole tests", seconds(run.stages.hole_test)},
           {"seconds for low-dimensional features", seconds(run.stages.degenerate)},
           {"seconds for the canonical form", seconds(run.stages.output)}}};
}

Computed by_slide(const Region& p, const Region& q, Boundary boundary,
                  const EngineOptions& options) {
  SlideResult result =
      slide_sum(p, q, boundary, {.with_origins = options.with_origins, .threads = options.threads});
  const SlideStatistics& run = result.statistics;
  return {std::move(result.sum),
          std::move(result.origins),
          {{"bits of a coordinate", std::to_string(run.bits)},
           {"free pieces of segments", std::to_string(run.free_pieces)},
           {"probes", std::to_string(run.probes)},
           {"pairs of boxes", std::to_string(run.box_pairs)},
           {"pairs of edges decided by doubles", std::to_string(run.by_doubles)},
           {"in integers of 64 bits", std::to_string(run.in_64_bits)},
           {"in integers of 256 bits", std::to_string(run.in_256_bits)},
           {"in integers of GMP", std::to_string(run.in_gmp)}}};
}

Computed by_rca(const Region& p, const Region& q, Boundary boundary, const EngineOptions& options) {
  return computed(rca(p, q, boundary, options.with_origins, options.hole_test));
}

Computed by_loops(const Region& p, const Region& q, Boundary boundary,
                  const EngineOptions& options) {
  return computed(sum_by_loops(p, q, boundary, options.with_origins, options.hole_test));
}

Computed by_winding_numbers(const Region& p, const Region& q, Boundary boundary,
                            const EngineOptions& options) {
  return computed(sum_by_winding_numbers(p, q, boundary, options.with_origins,
                                         collision_method(options.hole_test)));
}

Computed by_oracle(const Region& p, const Region& q, Boundary boundary,
                   const EngineOptions& options) {
  OracleSums sums = oracle_sums(p, q);
  MinkowskiSum& sum = boundary == Boundary::closed ? sums.closed : sums.open;
  Origins where_from = options.with_origins == WithOrigins::yes
                           ? origins(sum, reduced_convolution(p, q))
                           : Origins{};
  return {std::move(sum),
          std::move(where_from),
          {{"decided faces", std::to_string(sums.cells.faces)},
           {"decided edges", std::to_string(sums.cells.edges)},
           {"decided vertices", std::to_string(sums.cells.vertices)}}};
}

}  // namespace

const std::vector<Engine>& engines() {
  static const std::vector<Engine> table = {
      {"slide", "segments of the reduced convolution, no arrangement", false, true, by_slide},
      {"rca", "faces of the reduced convolution's arrangement", true, false, by_rca},
      {"loops", "orientable loops of the same (Behar and Lien)", true, false, by_loops},
      {"winding", "winding numbers on the full convolution (Wein)", true, false,
       by_winding_numbers},
      {"oracle", "the definitions, slowly", false, false, by_oracle},
  };
  return table;
}

const Engine* find_engine(const std::string& name) {
  const auto found = std::find_if(engines().begin(), engines().end(),
                                  [&](const Engine& engine) { return engine.name == name; });
  return found == engines().end() ? nullptr : &*found;
}

}  // namespace oplus
