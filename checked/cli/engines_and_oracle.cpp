// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/engines_and_oracle.hpp"

#include "checked/engines/engines.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

ComputedSum by_oracle(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options) {
  OracleSums sums = oracle_sums(p, q);
  ComputedSum result;
  result.sum = std::move(boundary == Boundary::closed ? sums.closed : sums.open);
  if (options.with_origins) result.origins = origins(result.sum, reduced_convolution(p, q));
  result.statistics = {{"decided faces", sums.cells.faces},
                       {"decided edges", sums.cells.edges},
                       {"decided vertices", sums.cells.vertices}};
  return result;
}

}  // namespace

const std::vector<Engine>& engines_and_oracle() {
  static const std::vector<Engine> table = [] {
    std::vector<Engine> all = engines();
    all.push_back({.name = "oracle", .what = "the definitions, slowly", .compute = by_oracle});
    return all;
  }();
  return table;
}

}  // namespace oplus
