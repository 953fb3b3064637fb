// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/checked_engines.hpp"

#include <memory>
#include <utility>

#include "checked/engines/engines.hpp"
#include "properties/runner/compared_hole_tests.hpp"

namespace oplus {

HoleTestMethod all_hole_tests() {
  return [](const Region& p, const Region& q) { return std::make_unique<ComparedHoleTests>(p, q); };
}

std::vector<Engine> checked_engines(const HoleTestMethod& hole_test) {
  std::vector<Engine> checked = engines();
  for (Engine& engine : checked)
    engine.compute = [compute = engine.compute, hole_test](const Region& p, const Region& q,
                                                           Boundary boundary,
                                                           EngineOptions options) {
      options.hole_test = hole_test;
      return compute(p, q, boundary, options);
    };
  return checked;
}

Engine named_engine(
    std::string name,
    std::function<PlanarSet(const Region& p, const Region& q, Boundary boundary)> sum) {
  return {.name = std::move(name),
          .compute = [sum = std::move(sum)](const Region& p, const Region& q, Boundary boundary,
                                            const EngineOptions& /*none*/) {
            return ComputedSum{sum(p, q, boundary), {}, {}};
          }};
}

}  // namespace oplus
