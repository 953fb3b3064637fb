// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <iostream>
#include <utility>

#include "checked/cycles/convolution_cycles.hpp"
#include "properties/experiments/growing_families.hpp"
#include "properties/experiments/plot.hpp"
#include "properties/experiments/process_of_its_own.hpp"
#include "properties/experiments/repetitions.hpp"
#include "reference/families/fork.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

/// Pairs in which both grow, but the L, and the convolution from n + m to a part of nm.
struct PairFamily {
  std::string name;
  std::size_t smallest;
  std::size_t largest;
  Summands (*make)(Random& random, std::size_t size);
  std::string colour;
};

template <Region (*polygon)(Random&, std::size_t)>
Summands two(Random& random, std::size_t size) {
  Region p = polygon(random, size);
  return {std::move(p), polygon(random, size)};
}

const std::vector<PairFamily>& pair_families() {
  static const std::vector<PairFamily> families = {
      {"convex", 25, 1600, two<convex_polygon>, "#0072b2"},
      {"simple", 25, 400, two<simple_polygon>, "#009e73"},
      {"star", 25, 400, two<star_polygon>, "#d55e00"},
      {"fork", 5, 160, [](Random&, std::size_t teeth) { return fork_and_l(teeth); }, "#cc79a7"},
  };
  return families;
}

std::string digest(std::vector<Origin> origins) {
  std::sort(origins.begin(), origins.end());
  std::string all;
  for (const auto& [edge_of, edge, vertex] : origins)
    all += (edge_of == Summand::P ? 'P' : 'Q') + std::to_string(edge.vertex) + ',' +
           std::to_string(vertex.vertex);
  return std::to_string(std::hash<std::string>()(all));
}

std::vector<Origin> origins(const std::vector<ConvolutionSegment>& segments) {
  std::vector<Origin> result;
  for (const ConvolutionSegment& s : segments) result.push_back(s.origin);
  return result;
}

/// The definition: every edge against every vertex.
Row measured_naive(const Summands& pair) {
  const std::vector<ConvolutionSegment> found = convolution(pair.p, pair.q);
  const double seconds =
      median_seconds(repetitions(found.size()), [&] { return convolution(pair.p, pair.q); });
  return {{"time", seconds}, {"digest", digest(origins(found))}};
}

Row measured_tracing(const Summands& pair) {
  const ConvolutionCycles found = convolution_cycles(pair.p, pair.q);
  const std::vector<Origin> of_segments = origins(full_convolution(found));
  const std::size_t times = repetitions(of_segments.size());
  const double seconds = median_seconds(times, [&] { return convolution_cycles(pair.p, pair.q); });
  return {{"time", seconds},
          {"no_points_time", median_seconds(times, [&] { return traced_origins(pair.p, pair.q); })},
          {"m", vertex_count(pair.p)},
          {"n", vertex_count(pair.q)},
          {"segments", of_segments.size()},
          {"cycles", found.cycles.size()},
          {"steps", found.steps},
          {"digest", digest(of_segments)}};
}

Row row_of(const PairFamily& family, std::size_t size, const ExperimentSettings& settings,
           std::vector<std::string>& wrong) {
  const auto make = [&] {
    Random random = random_of("cycles " + family.name, settings.seed, size, 1);
    return family.make(random, size);
  };
  Row row = {{"family", family.name}, {"size", size}};
  const auto measure = [&](const std::string& name, Row (*measured)(const Summands&)) {
    const ProcessReport report =
        in_process_of_its_own([&] { return measured(make()).dump(); }, settings.memory_limit_mb);
    const bool done = report.kind == ProcessReport::Kind::done;
    row[name + "_outcome"] = done ? "done" : report.text;
    if (report.kind == ProcessReport::Kind::failed)
      wrong.push_back("cycles " + family.name + ' ' + std::to_string(size) + ": " + name + ' ' +
                      report.text);
    return done ? std::optional(Row::parse(report.text)) : std::nullopt;
  };
  const std::optional<Row> naive = measure("naive", measured_naive);
  const std::optional<Row> tracing = measure("tracing", measured_tracing);
  if (naive) row["naive_time"] = naive->at("time");
  if (tracing) {
    for (const std::string column : {"m", "n", "segments", "cycles", "steps"})
      row[column] = tracing->at(column);
    row["tracing_time"] = tracing->at("time");
    row["no_points_time"] = tracing->at("no_points_time");
    const auto of = [&](const std::string& column) { return row.at(column).get<double>(); };
    row["pairs"] = 2 * row.at("m").get<std::size_t>() * row.at("n").get<std::size_t>();
    row["steps_by_bound"] = of("steps") / (of("m") + of("n") + of("segments"));
    row["pairs_by_steps"] = of("pairs") / of("steps");
    if (naive) {
      row["factor"] = of("naive_time") / of("tracing_time");
      row["no_points_factor"] = of("naive_time") / of("no_points_time");
      row["same_segments"] = naive->at("digest") == tracing->at("digest");
      if (!row.at("same_segments").get<bool>())
        wrong.push_back("cycles " + family.name + ' ' + std::to_string(size) +
                        ": the convolutions differ");
    }
  }
  return row;
}

std::optional<Plot> plot(const Table& table, const std::string& name, const std::string& title,
                         const std::string& column, const std::string& label) {
  std::vector<Series> series;
  for (const PairFamily& family : pair_families())
    series.push_back({column, family.name, family.colour, std::nullopt,
                      "strcol(\"family\") eq \"" + family.name + "\""});
  return plot_of(name, "cycles.csv", table, {title, "m", "vertices of P", label, true}, series);
}

}  // namespace

ExperimentResult run_cycles(const ExperimentSettings& settings) {
  ExperimentResult result;
  result.title = "Tracing cycles, and every edge against every vertex";
  result.table.columns = {"family",
                          "size",
                          "m",
                          "n",
                          "segments",
                          "cycles",
                          "steps",
                          "pairs",
                          "steps_by_bound",
                          "pairs_by_steps",
                          "naive_time",
                          "tracing_time",
                          "no_points_time",
                          "factor",
                          "no_points_factor",
                          "same_segments",
                          "naive_outcome",
                          "tracing_outcome"};
  double largest = 0;
  for (const PairFamily& family : pair_families()) {
    for (const std::size_t size : doubling_sizes(family.smallest, family.largest, settings.scale)) {
      Row row = row_of(family, size, settings, result.wrong);
      const std::optional<double> factor = number(row, "factor");
      std::cout << "cycles " << family.name << ' ' << size << ": "
                << (factor ? shown(*factor) + " times faster than all pairs" : "not measured")
                << std::endl;
      largest = std::max(largest, number(row, "steps_by_bound").value_or(0));
      result.table.rows.push_back(std::move(row));
    }
  }
  result.shown = {
      {"K: segments of the convolution. Naive: the definition, 2nm pairs. Times in "
       "milliseconds; without points: which segments there are, not where.",
       {{"family", "family"},
        {"m", "m"},
        {"n", "n"},
        {"K", "segments"},
        {"cycles", "cycles"},
        {"steps", "steps"},
        {"steps / (n+m+K)", "steps_by_bound"},
        {"2nm / steps", "pairs_by_steps"},
        {"naive", "naive_time", 1000},
        {"tracing", "tracing_time", 1000},
        {"without points", "no_points_time", 1000},
        {"naive / tracing", "factor"},
        {"naive / without points", "no_points_factor"},
        {"same segments", "same_segments"}}}};
  result.summary = {"steps / (n + m + K) is at most " + shown(largest)};
  add(result.plots, plot(result.table, "cycles-factor", "Naive time / tracing time", "factor",
                         "naive time / tracing time"));
  add(result.plots, plot(result.table, "cycles-steps", "Pairs looked at / steps", "pairs_by_steps",
                         "2nm / steps"));
  return result;
}

}  // namespace oplus
