// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>

#include <algorithm>
#include <iostream>
#include <tuple>

#include "checked/arrangement/hole_test.hpp"
#include "checked/certificates/certificate.hpp"
#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/json_values.hpp"
#include "checked/cli/origins_json.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/cli/view.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "checked/timed.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

namespace {

struct SumOptions {
  std::string p;
  std::string q;
  RegionOutput output;
  Overlaps overlaps = Overlaps::refused;
  Boundary boundary = Boundary::closed;
  std::string engine = engines_and_oracle().front().name;
  std::string hole_test;            ///< empty: the default
  std::optional<unsigned> threads;  ///< by default as many as there are cores
  std::optional<std::string> svg;
  std::optional<std::string> origins;
  std::optional<std::string> certificate;
  bool stats = false;
  std::optional<std::string> stats_json;
};

std::vector<std::string> outputs(const SumOptions& options) {
  std::vector<std::string> paths = {options.output.path};
  if (options.origins) paths.push_back(*options.origins);
  if (options.certificate) paths.push_back(*options.certificate);
  if (options.stats_json) paths.push_back(*options.stats_json);
  return paths;
}

/// For what is said of convolutions, which unbounded regions have none of.
void require_plain(const SumOptions& options) {
  if (options.svg || options.origins || options.certificate || options.stats || options.stats_json)
    throw UsageError(
        "--svg, --origins, --certificate, --stats and --stats-json are for bounded regions");
}

/// More segments are not drawn: nobody could tell them apart.
constexpr std::size_t most_drawn = 20000;

/// The segments in the order of the definition: by the edge's summand, by chains, by edge and vertex.
std::vector<Segment> in_order(std::vector<ConvolutionSegment> convolution) {
  const auto place = [](const ConvolutionSegment& s) {
    const auto& [edge_of, edge, vertex] = s.origin;
    return std::tuple(edge_of, edge.chain, vertex.chain, edge.vertex, vertex.vertex);
  };
  std::ranges::sort(convolution, {}, place);
  return segments(convolution);
}

std::string picture(const Region& p, const Region& q, const PlanarSet& sum) {
  const ConvolutionSize size = convolution_size(p, q);
  std::vector<Panel> panels = {panel_of(Summand::P, p), panel_of(Summand::Q, q)};
  if (size.segments <= most_drawn)
    panels.push_back(convolution_panel(in_order(traced_convolution(p, q))));
  if (size.reduced_segments <= most_drawn)
    panels.push_back(reduced_convolution_panel(in_order(traced_reduced_convolution(p, q))));
  panels.push_back({"P \u2295 Q", layers_of(sum)});
  if (size.segments > most_drawn)
    say_note("the picture is without convolutions of more than " + std::to_string(most_drawn) +
             " segments");
  return svg(panels);
}

void print(const Statistics& statistics) {
  for (const auto& [name, value] : statistics)
    std::cerr << std::string(name) + ": " + in_text(value) + "\n";
}

/// Sizes of the summands and of their convolution.
Statistics statistics_of(const Region& p, const Region& q) {
  const ConvolutionSize size = convolution_size(p, q);
  return {{"vertices of P", vertex_count(p)},
          {"vertices of Q", vertex_count(q)},
          {"segments of the convolution", size.segments},
          {"segments of the reduced convolution", size.reduced_segments},
          {"convolution cycles", size.cycles},
          {"steps to trace them", size.steps}};
}

/// What a run was, but for what only its end shows.
struct Run {
  Statistics summands;  ///< empty unless asked for; so is `sum`
  Statistics engine;
  Statistics sum;
  ReadingTimes input;
  Seconds counting{};
  Seconds computing{};
  Seconds region{};
  Seconds certificate{};
  Seconds drawing{};
  Seconds writing{};
  std::string note;  ///< of what was written; empty where there is nothing to say
};

/// What the user waited for: each stage, and all together since the command was understood. The rest of
/// the time is mostly that of freeing memory.
Statistics times_of(const Run& run, Seconds all) {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return {{"seconds for reading", run.input.reading},
          {"seconds for validation", run.input.validation},
          {"seconds for counting the convolution", run.counting},
          {"seconds for the sum", run.computing},
          {"seconds for the region", run.region},
          {"seconds for the certificate", run.certificate},
          {"seconds for the picture", run.drawing},
          {"seconds for writing", run.writing},
          {"seconds", all},
          {"peak memory in kilobytes", static_cast<std::size_t>(used.ru_maxrss)}};
}

std::string statistics_json(const SumOptions& options, const Run& run, const Statistics& times) {
  Json object = {{"engine", options.engine},
                 {"boundary", name(options.boundary)},
                 {"summands", json(run.summands)},
                 {"run", json(run.engine)},
                 {"sum", json(run.sum)}};
  object.update(json(times));
  return object.dump(2) + "\n";
}

HoleTestMethod chosen_hole_test(const SumOptions& options, const Engine& engine) {
  if (options.hole_test.empty()) return {};
  if (!engine.has_hole_test)
    throw UsageError("--collision-test is unsupported by the engine " + engine.name);
  return std::find_if(hole_test_methods().begin(), hole_test_methods().end(),
                      [&](const auto& method) { return method.first == options.hole_test; })
      ->second;
}

/// The same of sets of which one at least has segments or points (docs/polylines.md).
void sum_sets(const SumOptions& options, const Engine& engine, const EngineOptions& engine_options,
              Format format, const ReadSet& read_p, const ReadSet& read_q) {
  const auto require_not = [](bool is_given, const std::string& option) {
    if (is_given)
      throw UsageError(option + " is for sums of regions; a summand has line strings or points");
  };
  require_not(options.origins.has_value(), "--origins");
  require_not(options.certificate.has_value(), "--certificate");
  require_not(options.stats, "--stats");
  require_not(options.stats_json.has_value(), "--stats-json");
  const ShownStep step("computing the sum");
  const PlanarSet p = union_in(read_p), q = union_in(read_q);
  if (options.svg && (p.is_unbounded || q.is_unbounded))
    throw UsageError("--svg is for bounded sets");
  const PlanarSet sum = unbounded_sum(p, q, options.boundary,
                                      [&](const Region& a, const Region& b, Boundary boundary) {
                                        return engine.compute(a, b, boundary, engine_options).sum;
                                      });
  const OutputText content =
      output_text(options.output, format, sum, region_of(sum), options.boundary);
  std::vector<OutputTo> others;
  if (options.svg)
    others.emplace_back(*options.svg, svg({panel_of_set(Summand::P, p),
                                           panel_of_set(Summand::Q, q),
                                           {"P \u2295 Q", layers_of(sum)}}));
  if (options.boundary == Boundary::open && p.outer.empty() && q.outer.empty() && !p.is_unbounded &&
      !q.is_unbounded)
    say_note("neither summand has inner points, so the open sum is empty");
  write_output(options.output, content, std::move(others));
}

/// All that a user waits for: at its end all memory is free again.
Run done(const SumOptions& options, const Engine& engine, EngineOptions engine_options,
         Format format, Outputs& outputs) {
  Run run;
  const bool with_statistics = options.stats || options.stats_json;
  ReadSet read_p = read_summand_set(options.p, &run.input, options.overlaps);
  ReadSet read_q = read_summand_set(options.q, &run.input, options.overlaps);
  if (!is_region(read_p) || !is_region(read_q)) {
    sum_sets(options, engine, engine_options, format, read_p, read_q);
    return run;
  }
  Region p = std::move(read_p.region);
  Region q = std::move(read_q.region);
  if (is_unbounded(p) || is_unbounded(q)) require_plain(options);
  if (with_statistics) run.summands = timed(run.counting, [&] { return statistics_of(p, q); });

  ShownStep step(step_of_sum(p, q));
  engine_options.progress = [&](std::size_t segments, std::size_t total) {
    step.advance(segments, total);
  };
  ComputedSum computed;
  const auto by_engine = [&](const Region& a, const Region& b, Boundary boundary) {
    computed = engine.compute(a, b, boundary, engine_options);
    return std::move(computed.sum);
  };
  computed.sum =
      timed(run.computing, [&] { return unbounded_sum(p, q, options.boundary, by_engine); });
  if (!options.svg && !options.origins && !options.certificate) p = q = {};
  const bool is_rounded = output_grid(options.output).has_value();
  const Region region = timed(run.region, [&] {
    return is_rounded ? Region{} : region_of(computed.sum);  // another one is written
  });
  // Before anything is written, in case it cannot be made.
  const std::string certificate = timed(run.certificate, [&] {
    if (!options.certificate) return std::string();
    step.next("making the certificate");
    return written(
        options.boundary == Boundary::closed
            ? certificates::certificate(p, q, region)
            : certificates::open_certificate(
                  p, q, {region, computed.sum.dangling_edges, computed.sum.isolated_vertices}));
  });
  step.next("writing the sum");
  std::vector<OutputTo> others;
  if (options.svg)
    timed(run.drawing, [&] { others.emplace_back(*options.svg, picture(p, q, computed.sum)); });
  timed(run.writing, [&] {
    OutputText content =
        output_text(options.output, format, computed.sum, region, options.boundary);
    run.note = std::move(content.note);
    others.emplace_back(options.output.path, std::move(content.text));
    if (options.origins)
      others.emplace_back(*options.origins, origins_json(computed.sum, computed.origins, p, q));
    if (options.certificate) others.emplace_back(*options.certificate, certificate);
    outputs.write(others);
  });
  if (with_statistics) run.sum = timed(run.counting, [&] { return statistics_of(computed.sum); });
  run.engine = std::move(computed.statistics);
  return run;
}

ExitCode sum(const SumOptions& options) {
  const Engine& engine = *find_engine(engines_and_oracle(), options.engine);
  const EngineOptions engine_options = {.with_origins = options.origins.has_value(),
                                        .threads = threads_of(engine, options.threads),
                                        .hole_test = chosen_hole_test(options, engine)};
  require_one_standard_input({options.p, options.q});
  require_certifiable(options.certificate, options.output);
  require_writable(outputs(options), options.svg);
  const Format format = output_format(options.output);

  Seconds all{};
  Outputs outputs;
  const Run run =
      timed(all, [&] { return done(options, engine, engine_options, format, outputs); });
  const Statistics times = times_of(run, all);
  if (options.stats_json)
    outputs.write({{*options.stats_json, statistics_json(options, run, times)}});
  outputs.finish();
  if (!run.note.empty()) say_note(run.note);
  if (options.stats)
    for (const Statistics& part : {run.summands, run.engine, run.sum, times}) print(part);
  return ExitCode::done;
}

std::string engine_help() {
  return "how to compute, by default " + engines_and_oracle().front().name + ": " +
         joined(
             engines_and_oracle(),
             [](const Engine& engine) { return engine.name + ", " + engine.what; }, "; ");
}

}  // namespace

void add_sum(Program& program) {
  const auto& [command, options] = program.add(
      "sum", "Compute the Minkowski sum of two regions, or of sets with line strings and points",
      sum);
  command
      .file(
          "P", options.p,
          "a region (docs/files.md), which may be unbounded (.dat); also line strings, points, and "
          "collections of all three; - is standard input")
      .required();
  command.file("Q", options.q, "the other one, in any of these formats; it may be unbounded, too")
      .required();
  add_output(command, options.output, "the sum");
  add_union(command, options.overlaps, "P, and of Q");
  add_open(
      command, options.boundary,
      "sum the regions' interiors: keeps dangling edges and isolated vertices; of line strings and "
      "points with a region, its interior at each of their points");
  command.option("--engine NAME", options.engine, engine_help())
      .one_of(names_of(engines_and_oracle()));
  const std::vector<std::string> collision_tests =
      texts(hole_test_methods(), &std::pair<std::string, HoleTestMethod>::first);
  command
      .option("--collision-test NAME", options.hole_test,
              "how rca and loops decide what their filters leave open, and winding which "
              "low-dimensional features there are: bvh (the default), hierarchies of bounding "
              "volumes; sweep, a sweep line; naive, all pairs of edges; ray, rays through the "
              "full convolution. The sum is the same")
      .one_of(collision_tests);
  command.option("--hole-test", options.hole_test, "").one_of(collision_tests);
  add_threads(command, options.threads, " of the engine slide");
  command.file(
      "--svg", options.svg,
      "draw summands, convolutions and sum there, as SVG; convolutions of up to 20000 segments");
  command.file("--origins", options.origins,
               "write there, as JSON, which vertex and edge each edge of the sum came from");
  add_certificate(command, options.certificate, "the sum");
  command.flag("--stats", options.stats,
               "print sizes, times of all stages and memory to standard error");
  command.file("--stats-json", options.stats_json,
               "write the same there, as JSON (docs/json.md); - is standard output");
  command.footer(
      "An unbounded region is written as .dat, with 0 vertices in place of an outer chain: 0 and 0 are the\n"
      "plane, 0 alone is the empty set.\n"
      "\n"
      "Example:\n"
      "  oplus gen comb --n 5 --summand P -o p.wkt\n"
      "  oplus gen comb --n 5 --summand Q -o q.wkt\n"
      "  oplus sum p.wkt q.wkt -o sum.wkt --svg sum.svg --stats\n"
      "  echo 'LINESTRING(0 0,4 0,4 3)' | oplus sum - q.wkt -o swept.wkt");
}

}  // namespace oplus
