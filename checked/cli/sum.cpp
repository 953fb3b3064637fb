// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <thread>

#include "checked/arrangement/hole_test.hpp"
#include "checked/cli/command_line/program_frame.hpp"
#include "checked/cli/engines_and_oracle.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/json_values.hpp"
#include "checked/cli/origins_json.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/statistics.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/timed.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

namespace {

struct SumOptions {
  std::string p;
  std::string q;
  RegionOutput output;
  Boundary boundary = Boundary::closed;
  std::string engine = engines_and_oracle().front().name;
  std::string hole_test;            ///< empty: the default
  std::optional<unsigned> threads;  ///< by default as many as there are cores
  std::optional<std::string> svg;
  std::optional<std::string> origins;
  bool stats = false;
  std::optional<std::string> stats_json;
};

std::vector<std::string> outputs(const SumOptions& options) {
  std::vector<std::string> paths = {options.output.path};
  if (options.origins) paths.push_back(*options.origins);
  if (options.stats_json) paths.push_back(*options.stats_json);
  return paths;
}

std::string picture(const Region& p, const Region& q, const MinkowskiSum& sum) {
  std::vector<Panel> panels = panels_of(p, q);
  panels.push_back({"P \u2295 Q", layers_of(sum)});
  return svg(panels);
}

void print(const Statistics& statistics) {
  for (const auto& [name, value] : statistics)
    std::cerr << std::string(name) + ": " + in_text(value) + "\n";
}

/// Sizes of the summands and of their convolution.
Statistics statistics_of(const Region& p, const Region& q) {
  const ConvolutionCycles cycles = convolution_cycles(p, q);
  return {{"vertices of P", vertex_count(p)},
          {"vertices of Q", vertex_count(q)},
          {"segments of the convolution", full_convolution(cycles).size()},
          {"segments of the reduced convolution", reduced_convolution(cycles).size()},
          {"convolution cycles", cycles.cycles.size()},
          {"steps to trace them", cycles.steps}};
}

std::string statistics_json(const SumOptions& options, const Region& p, const Region& q,
                            const ComputedSum& computed, Seconds seconds) {
  const Json object = {{"engine", options.engine},
                       {"boundary", name(options.boundary)},
                       {"summands", json(statistics_of(p, q))},
                       {"run", json(computed.statistics)},
                       {"sum", json(statistics_of(computed.sum))},
                       {"seconds", json(Quantity(seconds))}};
  return object.dump(2) + "\n";
}

HoleTestMethod chosen_hole_test(const SumOptions& options, const Engine& engine) {
  if (options.hole_test.empty()) return {};
  if (!engine.has_hole_test)
    throw UsageError("--hole-test is unsupported by the engine " + engine.name);
  return std::find_if(hole_test_methods().begin(), hole_test_methods().end(),
                      [&](const auto& method) { return method.first == options.hole_test; })
      ->second;
}

unsigned chosen_threads(const SumOptions& options, const Engine& engine) {
  if (!options.threads) return std::max(std::thread::hardware_concurrency(), 1U);
  if (!engine.has_threads)
    throw UsageError("--threads is unsupported by the engine " + engine.name);
  return *options.threads;
}

ExitCode sum(const SumOptions& options) {
  const Engine& engine = *find_engine(engines_and_oracle(), options.engine);
  const EngineOptions engine_options = {.with_origins = options.origins.has_value(),
                                        .threads = chosen_threads(options, engine),
                                        .hole_test = chosen_hole_test(options, engine)};
  require_one_standard_input({options.p, options.q});
  require_writable(outputs(options), options.svg);
  const Format format = output_format(options.output);
  const Region p = read_summand(options.p);
  const Region q = read_summand(options.q);

  Seconds seconds{};
  const ComputedSum computed =
      timed(seconds, [&] { return engine.compute(p, q, options.boundary, engine_options); });

  if (!can_hold(format, computed.sum))
    throw UsageError(
        ".dat cannot hold the dangling edges and isolated vertices of this sum; write .wkt or "
        ".geojson");
  const std::string content = written(computed.sum, format, options.output.digits);
  if (options.svg) write_text(*options.svg, picture(p, q, computed.sum));
  if (options.origins)
    write_text(*options.origins, origins_json(computed.sum, computed.origins, p, q));
  if (options.stats_json)
    write_text(*options.stats_json, statistics_json(options, p, q, computed, seconds));
  write_region(options.output, format, content);

  if (options.stats) {
    print(statistics_of(p, q));
    print(computed.statistics);
    print(statistics_of(computed.sum));
    print({{"seconds", seconds}});
  }
  return ExitCode::done;
}

std::string engine_help() {
  return "how to compute, by default " + engines_and_oracle().front().name + ": " +
         joined(
             engines_and_oracle(),
             [](const Engine& engine) { return engine.name + ", " + engine.what; }, "; ");
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const Engine& engine : engines_and_oracle()) names.push_back(engine.name);
  return names;
}

}  // namespace

void add_sum(CLI::App& program, Action& chosen) {
  const auto& [command, options] =
      add_subcommand(program, chosen, "sum", "Compute the Minkowski sum of two regions", sum);
  add_file(command, "P", options.p, "a region: .dat, WKT or GeoJSON; - is standard input")
      ->required();
  add_file(command, "Q", options.q, "the other region, in any of these formats")->required();
  add_output(command, options.output, "the sum");
  add_open(command, options.boundary,
           "sum the regions' interiors: keeps dangling edges and isolated vertices");
  command.add_option("--engine", options.engine, engine_help())
      ->check(CLI::IsMember(engine_names()))
      ->type_name("NAME");
  command
      .add_option("--hole-test", options.hole_test,
                  "how rca and loops decide what their filters leave open, and winding which "
                  "low-dimensional features there are: bvh (the default), hierarchies of bounding "
                  "volumes; sweep, a sweep line; naive, all pairs of edges; ray, rays through the "
                  "full convolution. The sum is the same")
      ->check(CLI::IsMember(hole_test_methods()))
      ->type_name("NAME");
  command
      .add_option("--threads", options.threads,
                  "the number of threads of the engine slide, by default one per core. The sum is "
                  "the same")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  add_file(command, "--svg", options.svg, "draw summands, convolutions and sum there, as SVG");
  add_file(command, "--origins", options.origins,
           "write there, as JSON, which vertex and edge each edge of the sum came from");
  command.add_flag("--stats", options.stats, "print sizes and times to standard error");
  add_file(command, "--stats-json", options.stats_json,
           "write sizes and times there, as JSON (docs/json.md); - is standard output");
  command.footer(
      "Example:\n"
      "  oplus gen comb --n 5 --summand P -o p.wkt\n"
      "  oplus gen comb --n 5 --summand Q -o q.wkt\n"
      "  oplus sum p.wkt q.wkt -o sum.wkt --svg sum.svg --stats");
}

}  // namespace oplus
