// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/engine.hpp"

#include <algorithm>

#include "checked/rca/rca.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Computed by_rca(const Region& p, const Region& q, Boundary boundary, bool with_origins) {
  RcaResult result = rca(p, q, boundary, with_origins ? WithOrigins::yes : WithOrigins::no);
  const RcaStatistics& run = result.statistics;
  return {std::move(result.sum),
          std::move(result.origins),
          {{"A_RC (arrangement edges)", std::to_string(run.arrangement_edges)},
           {"arrangement vertices", std::to_string(run.arrangement_vertices)},
           {"faces", std::to_string(run.arrangement_faces)},
           {"candidates", std::to_string(run.candidate_faces)},
           {"hole tests", std::to_string(run.hole_tests)}}};
}

Computed by_oracle(const Region& p, const Region& q, Boundary boundary, bool with_origins) {
  OracleSums sums = oracle_sums(p, q);
  MinkowskiSum& sum = boundary == Boundary::closed ? sums.closed : sums.open;
  Origins where_from = with_origins ? origins(sum, reduced_convolution(p, q)) : Origins{};
  return {std::move(sum),
          std::move(where_from),
          {{"decided faces", std::to_string(sums.cells.faces)},
           {"decided edges", std::to_string(sums.cells.edges)},
           {"decided vertices", std::to_string(sums.cells.vertices)}}};
}

}  // namespace

const std::vector<Engine>& engines() {
  static const std::vector<Engine> table = {
      {"rca", "the arrangement of the reduced convolution", by_rca},
      {"oracle", "the definitions, slowly", by_oracle},
  };
  return table;
}

const Engine* find_engine(const std::string& name) {
  const auto found = std::find_if(engines().begin(), engines().end(),
                                  [&](const Engine& engine) { return engine.name == name; });
  return found == engines().end() ? nullptr : &*found;
}

}  // namespace oplus
