// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/operations.hpp"

#include "checked/certificates/certificate.hpp"
#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/cli/view.hpp"
#include "checked/operations/complement.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/io/writing.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

namespace {

struct OperationOptions {
  Operation operation;
  std::string p;
  std::string q;
  RegionOutput output;
  Overlaps overlaps = Overlaps::refused;
  SpacingOptions spacing;
  std::optional<std::string> certificate;
  std::string engine = engines_and_oracle().front().name;
  std::optional<unsigned> threads;
  std::optional<std::string> svg;
};

Panel panel_of_summand(Summand which, const ReadSet& set) {
  return is_region(set) ? panel_of(which, set.region) : panel_of_set(which, union_in(set));
}

/// Throws UsageError where a certificate is asked for and there is none.
void require_certifiable(const OperationOptions& options, const ReadSet& p, const ReadSet& q) {
  if (!options.certificate) return;
  if (options.spacing.distance)
    throw UsageError("--certificate is for P and Q as they are, without --spacing");
  for (const ReadSet* set : {&p, &q})
    if (!is_region(*set) || is_unbounded(set->region))
      throw UsageError("--certificate is for bounded regions, without line strings and points");
  if (options.operation.boundary == Boundary::closed && q.region.components.empty())
    throw UsageError("--certificate is for a Q that is not empty");
}

/// The text of the certificate of a no-fit or an inner-fit polygon.
std::string certificate_of(const Operation& operation, const Region& p, const Region& q,
                           const ClaimedSum& set, const SumOf& sum) {
  return written(operation.boundary == Boundary::open
                     ? certificates::no_fit_certificate(p, q, set)
                     : certificates::inner_fit_certificate(p, q, set, sum));
}

ExitCode operate(const OperationOptions& options) {
  const Engine& engine = *find_engine(engines_and_oracle(), options.engine);
  const unsigned threads = threads_of(engine, options.threads);
  require_one_standard_input({options.p, options.q});
  std::vector<std::string> outputs = {options.output.path};
  if (options.certificate) outputs.push_back(*options.certificate);
  require_writable(outputs, options.svg);
  require_certifiable(options.certificate, options.output);
  const Format format = output_format(options.output);
  const std::optional<Region> disc = disc_of(options.spacing);
  const Operation& operation = options.operation;
  ReadSet p;
  if (operation.takes_any_p)
    p = read_summand_set(options.p, nullptr, options.overlaps);
  else
    p.region = read_summand(options.p, nullptr, Extent::any, options.overlaps);
  const ReadSet q = read_summand_set(options.q, nullptr, options.overlaps);
  require_certifiable(options, p, q);
  const SumOf sum = [&](const Region& a, const Region& b, Boundary boundary) {
    ShownStep step(step_of_sum(a, b));
    return engine
        .compute(
            a, b, boundary,
            {.threads = threads,
             .progress = [&](std::size_t done, std::size_t total) { step.advance(done, total); }})
        .sum;
  };
  const PlanarSet set = result_of(operation, p, disc ? spaced(q, *disc, sum) : q, sum);
  if (options.svg && (is_unbounded(p.region) || is_unbounded(q.region) || set.is_unbounded))
    throw UsageError("--svg is for bounded sets");
  if (operation.boundary == Boundary::open && !(is_region(p) && is_region(q)) &&
      p.region.components.empty() && q.region.components.empty())
    say_note("neither set has inner points, so they never overlap");
  const Region region = region_of(set);
  std::vector<OutputTo> others;
  if (options.certificate)
    others.emplace_back(*options.certificate,
                        certificate_of(operation, p.region, q.region,
                                       {region, set.dangling_edges, set.isolated_vertices}, sum));
  if (options.svg)
    others.emplace_back(*options.svg, svg({panel_of_summand(Summand::P, p),
                                           panel_of_summand(Summand::Q, q),
                                           {operation.name + " P Q", layers_of(set)}}));
  write_output(options.output, output_text(options.output, format, set, region, operation.boundary),
               std::move(others));
  return ExitCode::done;
}

struct ComplementOptions {
  std::string file;
  Overlaps overlaps = Overlaps::refused;
  RegionOutput output;
};

ExitCode complement_of(const ComplementOptions& options) {
  require_writable({options.output.path});
  const Format format = output_format(options.output);
  write_region(options.output, format,
               complement(read_summand(options.file, nullptr, Extent::any, options.overlaps)));
  return ExitCode::done;
}

}  // namespace

void add_operations(Program& program) {
  for (const Operation& operation : operations()) {
    if (!program.needs(operation.name)) continue;
    const auto& [command, options] =
        program.add(operation.name, "Compute " + operation.what, operate);
    options.operation = operation;
    command
        .file(
            "P", options.p,
            std::string("a region (docs/files.md), which may be unbounded (.dat)") +
                (operation.takes_any_p ? "; also line strings, points, and collections of all three"
                                       : "") +
                "; - is standard input")
        .required();
    command
        .file("Q", options.q,
              "the other one, in any of these formats; also line strings, points, and collections")
        .required();
    add_output(command, options.output, "the result");
    add_union(command, options.overlaps, "P, and of Q");
    if (operation.takes_spacing) {
      add_spacing(command, options.spacing);
      add_certificate(command, options.certificate, "the result");
    }
    command
        .option("--engine NAME", options.engine, "the engine that computes sums, as in oplus sum")
        .one_of(names_of(engines_and_oracle()));
    add_threads(command, options.threads, " of the engine slide");
    command.file("--svg", options.svg, "draw P, Q and the result there, as SVG");
    command.footer(
        "Q + x is Q moved by x. Where the two just fit, the result has edges and points of its own, written\n"
        "as line strings and points; those of nfp are not in it, those of ifp are.\n"
        "\n"
        "Example:\n"
        "  oplus gen tight --n 6 --summand P -o p.wkt\n"
        "  oplus gen tight --n 6 --summand Q -o q.wkt\n"
        "  oplus " +
        operation.name + " p.wkt q.wkt --svg " + operation.name + ".svg");
  }
}

void add_complement(Program& program) {
  const auto& [command, options] =
      program.add("complement", "Write the closure of a region's complement", complement_of);
  command
      .file("R", options.file,
            "a region (docs/files.md), which may be unbounded (.dat); - is standard input")
      .required();
  add_output(command, options.output, "the complement");
  add_union(command, options.overlaps, "R");
  command.footer(
      "The complement of a bounded region is unbounded. Only .dat holds that: 0 vertices in place of an\n"
      "outer chain, then the holes. 0 and 0 are the plane, and 0 alone is the empty set.\n"
      "\n"
      "Example:\n"
      "  oplus gen star --n 8 --summand P -o part.wkt\n"
      "  oplus complement part.wkt -o outside.dat\n"
      "  oplus complement outside.dat -o same.wkt");
}

}  // namespace oplus
