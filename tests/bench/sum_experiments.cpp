// SPDX-License-Identifier: GPL-3.0-or-later
// The engines of the thesis: rca for its RCA, winding for its CWEIN. Both find low-dimensional
// features, as there (Section 6.2.1). T is the time of all stages except the output.
#include <algorithm>

#include "reference/families/fork.hpp"
#include "reference/families/polygons.hpp"
#include "tests/bench/experiment.hpp"
#include "tests/bench/families.hpp"
#include "tests/bench/numbers.hpp"
#include "tests/bench/published_pairs.hpp"

namespace oplus {

namespace {

Row for_both_engines(Row row) {
  row.engines = {"rca", "winding"};
  row.boundary = Boundary::open;
  return row;
}

std::vector<Row> table_6_1(const ExperimentSettings&) {
  std::vector<Row> rows;
  for (const PublishedPair& pair : published_pairs()) {
    if (!pair.in_thesis) continue;
    Row row{.name = "table-6.1 " + pair.name,
            .what = pair.name,
            .words = {{"name", pair.name}},
            .numbers = {{"thesis_rca_edges", pair.in_thesis->a_rc},
                        {"thesis_winding_edges", pair.in_thesis->a_w},
                        {"thesis_rca_time", pair.in_thesis->t_rc},
                        {"thesis_winding_time", pair.in_thesis->t_w},
                        {"thesis_ratio", pair.in_thesis->t_rc / pair.in_thesis->t_w}}};
    if (pair.is_there()) row.make = [pair] { return std::vector<Summands>{pair.read()}; };
    rows.push_back(for_both_engines(row));
  }
  return rows;
}

void compare(Row& row) {
  const Measurement* rca = row.done("rca");
  const Measurement* winding = row.done("winding");
  if (rca == nullptr || winding == nullptr) return;
  row.words["same_sum"] = rca->digest == winding->digest ? "true" : "false";
  const auto with_output = [](const Measurement* m) {
    return m->numbers.at("time") + m->numbers.at("output");
  };
  row.numbers["ratio"] = *row.number("rca.time/winding.time");
  row.numbers["ratio_with_output"] = with_output(rca) / with_output(winding);
}

void compare_with_thesis(Row& row) {
  compare(row);
  for (const std::string engine : {"rca", "winding"})
    if (const auto edges = row.number(engine + ".edges"))
      row.words["same_" + engine + "_edges"] =
          edges == row.number("thesis_" + engine + "_edges") ? "true" : "false";
}

std::vector<std::string> columns_after(std::vector<std::string> first) {
  for (const std::string both :
       {"m", "n", "sum_chains", "sum_holes", "sum_edges", "sum_dangling", "sum_isolated",
        "same_sum", "ratio", "ratio_with_output", "rca_outcome", "winding_outcome"})
    first.push_back(both);
  return first;
}

/// The ratios of rca to winding: the first, the last, and the median.
std::vector<std::string> ratio_lines(const Rows& rows) {
  std::vector<std::string> lines;
  for (const auto& [column, with] :
       {std::pair{"ratio", ""}, {"ratio_with_output", " with output"}}) {
    std::vector<double> ratios = points(rows, column, column).x;
    if (ratios.empty()) continue;
    const std::string ends = three_digits(ratios.front()) + " at the first row, " +
                             three_digits(ratios.back()) + " at the last";
    std::sort(ratios.begin(), ratios.end());
    lines.push_back(std::string("T_RC / T_W") + with + ": " + ends + ", median " +
                    three_digits(ratios[ratios.size() / 2]));
  }
  return lines;
}

std::string r_squared_line(const std::string& curve, std::size_t degree, const Rows& rows,
                           const std::string& x, const std::string& of) {
  const auto r_squared = [&](const std::string& engine) {
    const std::optional<Fit> found = fitted_curve(degree, points(rows, x, engine + '.' + of));
    return found ? three_digits(found->r_squared) : "too few sizes";
  };
  return "R² of " + curve + ": rca " + r_squared("rca") + ", winding " + r_squared("winding");
}

/// The sizes of the arrangements show without a clock whether the work is quadratic.
std::vector<std::string> parabola_lines(const Rows& rows) {
  std::vector<std::string> lines = ratio_lines(rows);
  lines.push_back(r_squared_line("a parabola in m through the times", 2, rows, "m", "time"));
  lines.push_back(r_squared_line("one through the arrangements' edges", 2, rows, "m", "edges"));
  return lines;
}

std::vector<std::string> line_lines(const Rows& rows) {
  std::vector<std::string> lines = ratio_lines(rows);
  lines.push_back(
      r_squared_line("a line in A_W through the times", 1, rows, "winding.edges", "time"));
  const auto rca = fitted_curve(1, points(rows, "winding.edges", "rca.time"));
  const auto winding = fitted_curve(1, points(rows, "winding.edges", "winding.time"));
  if (rca && winding)
    lines.push_back("slope, microseconds per edge of A_W: rca " + three_digits(1e6 * rca->linear) +
                    ", winding " + three_digits(1e6 * winding->linear) + "; winding / rca " +
                    three_digits(winding->linear / rca->linear));
  return lines;
}

std::vector<std::string> thesis_lines(const Rows& rows) {
  const auto count = [&](const auto& is_one) {
    return std::to_string(std::count_if(rows.begin(), rows.end(), is_one));
  };
  const auto count_true = [&](const std::string& column) {
    return count([&](const Row& row) {
      const auto found = row.words.find(column);
      return found != row.words.end() && found->second == "true";
    });
  };
  return {count([](const Row& row) { return row.make != nullptr; }) + " pairs measured, " +
              count([](const Row& row) { return row.make == nullptr; }) +
              " skipped: missing in data/",
          "A_RC is as in the thesis in " + count_true("same_rca_edges") + " of them, A_W in " +
              count_true("same_winding_edges")};
}

std::vector<Plot> plots(const std::vector<std::string>& names) {
  std::vector<Plot> all;
  for (const std::string& name : names) all.push_back({name, "ratio"});
  return all;
}

/// Completes an experiment in which only P grows.
Experiment growing(Experiment experiment, const SizeRange& range,
                   Summands (*make)(Random& random, std::size_t size)) {
  experiment.rows = [=, name = experiment.name](const ExperimentSettings& settings) {
    std::vector<Row> rows;
    for (const std::size_t size : sizes(range, settings.scale))
      rows.push_back(for_both_engines(random_row(name, settings.seed, size, make)));
    return rows;
  };
  experiment.compare = compare;
  experiment.first_columns = columns_after({"size", "pair"});
  return experiment;
}

}  // namespace

std::vector<Experiment> sum_experiments() {
  return {
      {.name = "table-6.1",
       .what = "Wein's pairs, those that are published (Table 6.1)",
       .rows = table_6_1,
       .compare = compare_with_thesis,
       .first_columns = columns_after({"name", "thesis_rca_edges", "thesis_winding_edges",
                                       "thesis_rca_time", "thesis_winding_time", "thesis_ratio",
                                       "same_rca_edges", "same_winding_edges"}),
       .summary = thesis_lines},
      // The thesis's range (Section 6.2.4), but one pair per size instead of 20.
      growing({.name = "convex-star",
               .what = "Convex P grows, Q a star of 100 vertices (Figures 6.9 and 6.20a)",
               .summary = line_lines,
               .plots = plots({"figure-6.9", "figure-6.20a"}),
               .fitted_degree = 1,
               .fitted_over = "winding.edges"},
              {50, 980, 30}, with_100<convex_polygon, star_polygon>),
      // In the thesis to 340 in steps of 3; winding would need minutes and more than 10 GB per pair.
      growing({.name = "star-star",
               .what = "Star-shaped P grows, Q a star of 100 vertices (Figure 6.10)",
               .summary = parabola_lines,
               .plots = plots({"figure-6.10"}),
               .fitted_degree = 2,
               .fitted_over = "m"},
              {25, 160, 15}, with_100<star_polygon, star_polygon>),
      // In the thesis in steps of 5, five pairs per size.
      growing({.name = "simple-simple",
               .what = "Simple P grows, Q is simple with 100 vertices (Figures 6.11 to 6.13 and "
                       "6.20b)",
               .summary = parabola_lines,
               .plots = plots({"figure-6.11", "figure-6.12", "figure-6.13", "figure-6.20b"}),
               .fitted_degree = 2,
               .fitted_over = "m"},
              {30, 200, 10}, with_100<simple_polygon, simple_polygon>),
      // The thesis counts 50 to 250 teeth, about four times as many vertices, and n² holes. Ours have n
      // teeth per arm, 8n + 4 vertices and n² holes, the same numbers of vertices and of holes.
      growing({.name = "fork-l",
               .what = "A fork grows, Q is an L (Figures 6.14 to 6.16)",
               .summary = ratio_lines,
               .plots = plots({"figure-6.14", "figure-6.15", "figure-6.16", "fork-ratio"})},
              {10, 250, 30}, [](Random&, std::size_t teeth) { return fork_and_l(teeth); }),
  };
}

}  // namespace oplus
