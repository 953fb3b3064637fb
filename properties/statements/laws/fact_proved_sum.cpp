// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "checked/engines/engines.hpp"
#include "properties/compare/engine_called.hpp"
#include "properties/runner/registry.hpp"
#include "reference/io/boundary_name.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  Outcome outcome;
  const auto& [p, q] = summands;
  const std::string fault = why_it_cannot_run("proved", {});
  if (!fault.empty()) return outcome.fail(fault);
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const PlanarSet proved = proved_engine({}).compute(p, q, boundary, {}).sum;
    for (const Engine& engine : engines())
      if (engine.compute(p, q, boundary, {}).sum != proved)
        return outcome.fail(engine.name + ", " + std::string(name(boundary)) +
                            ": another sum than the proved one");
    outcome.counts["holes of sums"] += proved.holes.size();
    outcome.counts["edges and points of open sums"] +=
        proved.dangling_edges.size() + proved.isolated_vertices.size();
  }
  return outcome;
}

const Registered registered(tight_mixture(), {.id = "fact-proved-sum",
                                              .kills = {"slide-components-never-overlap",
                                                        "slide-shifts-to-the-left"},
                                              .cases = 100,
                                              .check = check});

}  // namespace

}  // namespace oplus
