// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "reference/families/fork.hpp"
#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"
#include "tests/bench/experiment.hpp"
#include "tests/bench/families.hpp"
#include "tests/bench/numbers.hpp"

namespace oplus {

namespace {

/// Pairs in which both summands grow, except the L, and the convolution has from n + m to about nm
/// segments.
struct PairFamily {
  std::string name;
  SizeRange range;
  Summands (*make)(Random& random, std::size_t size);
};

std::vector<Row> rows(const ExperimentSettings& settings) {
  const std::vector<PairFamily> families = {
      {"convex", {25, 1600}, two<convex_polygon>},
      {"simple", {25, 400}, two<simple_polygon>},
      {"star", {25, 400}, two<star_polygon>},
      {"fork", {5, 160}, [](Random&, std::size_t teeth) { return fork_and_l(teeth); }},
  };
  std::vector<Row> all;
  for (const PairFamily& family : families) {
    for (const std::size_t size : sizes(family.range, settings.scale)) {
      Row row = random_row("cycles " + family.name, settings.seed, size, family.make);
      row.words["family"] = family.name;
      row.subject = Subject::convolution;
      row.engines = {"naive", "traced", "without-points"};
      all.push_back(std::move(row));
    }
  }
  return all;
}

/// Compares the steps with their bound n + m + K, and with the number of pairs that the definition tests.
void compare(Row& row) {
  for (const std::string name : {"m", "n", "segments", "cycles", "steps"})
    if (const auto found = row.number("traced." + name)) row.numbers[name] = *found;
  if (row.done("traced") == nullptr) return;
  std::map<std::string, double>& of = row.numbers;
  of["pairs"] = 2 * of["m"] * of["n"];
  of["steps_by_bound"] = of["steps"] / (of["m"] + of["n"] + of["segments"]);
  of["pairs_by_steps"] = of["pairs"] / of["steps"];
  if (const auto factor = row.number("naive.seconds/traced.seconds")) of["factor"] = *factor;
  if (const auto factor = row.number("naive.seconds/without-points.seconds"))
    of["no_points_factor"] = *factor;
  const Agreement agreement = agreement_of(row);
  if (agreement.compared > 1)
    row.words["same_segments"] = agreement.disagreement.empty() ? "true" : "false";
}

std::vector<std::string> summary(const Rows& rows) {
  const std::vector<double> all = points(rows, "steps_by_bound", "steps_by_bound").x;
  const double largest = all.empty() ? 0 : *std::max_element(all.begin(), all.end());
  return {"steps / (n + m + K) is at most " + three_digits(largest)};
}

}  // namespace

Experiment cycle_experiment() {
  return {.name = "cycles",
          .what = "Cycle tracing and all pairs of an edge and a vertex (Theorem 4.1.10)",
          .rows = rows,
          .compare = compare,
          .first_columns = {"family", "size", "m", "n", "segments", "cycles", "steps", "pairs",
                            "steps_by_bound", "pairs_by_steps", "factor", "no_points_factor",
                            "same_segments"},
          .summary = summary,
          .plots = {{"cycles-factor", "factor"}, {"cycles-steps", "pairs_by_steps"}}};
}

}  // namespace oplus
