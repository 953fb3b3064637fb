// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/fork.hpp"

#include "properties/experiments/engine_plots.hpp"
#include "properties/experiments/engine_tables.hpp"
#include "properties/experiments/growing_families.hpp"

namespace oplus {

namespace {

// The thesis has 50 to 250 teeth, "about four times" as many vertices, and says n² holes. Ours have
// n teeth an arm, 8n + 4 vertices, n² holes: these are its numbers of vertices and of holes.
const GrowingFamily fork_l = {
    "fork-l", {10, 250, 30}, 1, [](Random&, std::size_t teeth) { return fork_and_l(teeth); }};

}  // namespace

ExperimentResult run_fork_l(const ExperimentSettings& settings) {
  ExperimentResult result;
  result.title = "Fork and L";
  result.table = measured_family(fork_l, settings, result.wrong);
  result.shown = shown_engine_tables({{"teeth an arm", "size"}});
  result.summary = ratio_lines(result.table);
  const EnginePlots plots{fork_l.name + ".csv", result.table};
  add(result.plots, plots.times("figure-6.14", "Figure 6.14: fork and L", "m", "vertices of P",
                                std::nullopt, std::nullopt));
  add(result.plots,
      plots.stages("figure-6.15", "Figure 6.15: fork and L, stages of CWEIN", "winding"));
  add(result.plots, plots.stages("figure-6.16", "Figure 6.16: fork and L, stages of RCA", "rca"));
  add(result.plots, plots.ratio("fork-ratio", "Fork and L: how much slower RCA is"));
  return result;
}

}  // namespace oplus
