// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/engine_plots.hpp"
#include "properties/experiments/engine_tables.hpp"
#include "properties/experiments/growing_families.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

constexpr std::size_t vertices_of_q = 100;

// The thesis's range (Section 6.2.4), but one pair a size instead of 20.
const GrowingFamily convex_star = {
    "convex-star", {50, 980, 30}, 1, [](Random& random, std::size_t m) {
      Region p = convex_polygon(random, m);
      return Summands{std::move(p), star_polygon(random, vertices_of_q)};
    }};

// In the thesis to 340 in steps of 3, which takes winding minutes and more than 10 GB a pair.
const GrowingFamily star_star = {
    "star-star", {25, 160, 15}, 1, [](Random& random, std::size_t m) {
      Region p = star_polygon(random, m);
      return Summands{std::move(p), star_polygon(random, vertices_of_q)};
    }};

// In the thesis in steps of 5, five pairs a size.
const GrowingFamily simple_simple = {
    "simple-simple", {30, 200, 10}, 1, [](Random& random, std::size_t m) {
      Region p = simple_polygon(random, m);
      return Summands{std::move(p), simple_polygon(random, vertices_of_q)};
    }};

/// The curves through the times of both engines, as far as there are points enough.
struct Fits {
  std::optional<Fit> rca;
  std::optional<Fit> winding;
};

/// `of` is what is fitted: time or edges.
Fits fits(const Table& table, const std::string& x, const std::string& of,
          std::optional<Fit> (*fit)(const std::vector<double>&, const std::vector<double>&)) {
  const auto fitted = [&](const std::string& column) {
    const auto [xs, ys] = points(table, x, column);
    return fit(xs, ys);
  };
  return {fitted("rca_" + of), fitted("winding_" + of)};
}

std::string r_squared_line(const std::string& curve, const Fits& fits) {
  const auto of = [](const std::optional<Fit>& fit) {
    return fit ? shown(fit->r_squared) : "too few sizes";
  };
  return "R² of " + curve + ": rca " + of(fits.rca) + ", winding " + of(fits.winding);
}

/// The arrangements' sizes say without any clock whether the work is quadratic.
void add_parabola_lines(ExperimentResult& result, const Fits& of_times) {
  result.summary.push_back(r_squared_line("a parabola in m through the times", of_times));
  result.summary.push_back(r_squared_line("one through the arrangements' edges",
                                          fits(result.table, "m", "edges", fit_parabola)));
}

ExperimentResult result_of(const GrowingFamily& family, const ExperimentSettings& settings,
                           const std::string& title) {
  ExperimentResult result;
  result.title = title;
  result.table = measured_family(family, settings, result.wrong);
  result.shown = shown_engine_tables({{"pair", "pair"}});
  result.summary = ratio_lines(result.table);
  return result;
}

}  // namespace

ExperimentResult run_convex_star(const ExperimentSettings& settings) {
  ExperimentResult result =
      result_of(convex_star, settings, "Convex P, star-shaped Q of 100 vertices");
  const Fits lines = fits(result.table, "winding_edges", "time", fit_line);
  result.summary.push_back(r_squared_line("a line in A_W through the times", lines));
  if (lines.rca && lines.winding)
    result.summary.push_back("slope, microseconds an edge of A_W: rca " +
                             shown(1e6 * lines.rca->linear) + ", winding " +
                             shown(1e6 * lines.winding->linear) + "; winding / rca " +
                             shown(lines.winding->linear / lines.rca->linear));
  const EnginePlots plots{convex_star.name + ".csv", result.table};
  add(result.plots,
      plots.times("figure-6.9", "Figure 6.9: convex and star", "winding_edges",
                  "edges of the full convolution's arrangement", lines.rca, lines.winding));
  add(result.plots, plots.memory("figure-6.20a", "Figure 6.20 (a): convex and star"));
  return result;
}

ExperimentResult run_star_star(const ExperimentSettings& settings) {
  ExperimentResult result =
      result_of(star_star, settings, "Star-shaped P, star-shaped Q of 100 vertices");
  const Fits parabolas = fits(result.table, "m", "time", fit_parabola);
  add_parabola_lines(result, parabolas);
  const EnginePlots plots{star_star.name + ".csv", result.table};
  add(result.plots, plots.times("figure-6.10", "Figure 6.10: star and star", "m", "vertices of P",
                                parabolas.rca, parabolas.winding));
  return result;
}

ExperimentResult run_simple_simple(const ExperimentSettings& settings) {
  ExperimentResult result =
      result_of(simple_simple, settings, "Simple P, simple Q of 100 vertices");
  const Fits parabolas = fits(result.table, "m", "time", fit_parabola);
  add_parabola_lines(result, parabolas);
  const EnginePlots plots{simple_simple.name + ".csv", result.table};
  add(result.plots, plots.times("figure-6.11", "Figure 6.11: simple and simple", "m",
                                "vertices of P", parabolas.rca, parabolas.winding));
  add(result.plots,
      plots.stages("figure-6.12", "Figure 6.12: simple and simple, stages of CWEIN", "winding"));
  add(result.plots,
      plots.stages("figure-6.13", "Figure 6.13: simple and simple, stages of RCA", "rca"));
  add(result.plots, plots.memory("figure-6.20b", "Figure 6.20 (b): simple and simple"));
  return result;
}

}  // namespace oplus
