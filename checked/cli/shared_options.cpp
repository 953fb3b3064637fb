// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/shared_options.hpp"

#include <algorithm>
#include <thread>

#include "checked/cli/input.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/engines/engines.hpp"
#include "checked/operations/disc.hpp"
#include "reference/chains/nesting.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/quoting.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

void add_output(const Command& command, RegionOutput& output, const std::string& what) {
  command.file("-o,--output", output.path,
               "write " + what + " there; by default to standard output");
  command.choice<Format>(
      "--format", output.format,
      {{"wkt", Format::wkt},
       {"dat", Format::dat},
       {"geojson", Format::geojson},
       {"wkb", Format::wkb}},
      "write wkt, dat, geojson or wkb (in hexadecimal digits); by default what the ending of FILE "
      "says, and wkt on standard output");
  add_rounding(command, output);
}

void add_rounding(const Command& command, RoundingOptions& rounding) {
  command.option(
      "--grid STEP", rounding.grid,
      "round to multiples of STEP, so that the output is valid and, where these are decimals, "
      "without fractions (docs/rounding.md); by default it is exact, with fractions p/q where a "
      "decimal would not end");
  command.option("--digits N", rounding.digits, "round to N decimals: short for --grid 10^-N")
      .range(0, most_digits);
  command.choice<Side>(
      "--side", rounding.side,
      {{"nearest", Side::nearest}, {"contain", Side::contain}, {"contained", Side::contained}},
      "what is rounded is nearest, moved by at most half a step in x and in y (the default); "
      "or it is to contain the exact set, or to be contained in it, and differs by at most a "
      "step in x and in y");
}

Option add_angle_error(const Command& command, std::string& error) {
  return command.option(
      "--angle-error E", error,
      "rotations are exact, but by at most E degrees more or less than the angle that was asked "
      "for, " +
          std::string(default_angle_error) +
          " by default, with the smallest denominator of those; not by multiples of 90 degrees. "
          "The exact cosine and sine are said");
}

Rational angle_error(const std::string& text) {
  Rational error = number("--angle-error", text);
  if (sgn(error) <= 0) throw UsageError("--angle-error takes degrees above 0, not " + quote(text));
  return error;
}

void add_union(const Command& command, Overlaps& overlaps, const std::string& what) {
  command.flag(
      "--union", [&overlaps] { overlaps = Overlaps::allowed; },
      "take the union of the polygons of " + what +
          ", which may overlap, share edges and contain each other; each by itself must be valid");
}

void add_threads(const Command& command, std::optional<unsigned>& threads,
                 const std::string& what) {
  command
      .option("--threads N", threads,
              "the number of threads" + what +
                  ", by default or with 0 one per core. The result is the same")
      .range(0, 1024);
}

unsigned number_of(const std::optional<unsigned>& threads) {
  return threads && *threads > 0 ? *threads : std::max(std::thread::hardware_concurrency(), 1U);
}

unsigned threads_of(const Engine& engine, const std::optional<unsigned>& threads) {
  if (threads && !engine.has_threads)
    throw UsageError("--threads is unsupported by the engine " + engine.name);
  return number_of(threads);
}

std::string step_of_sum(const Region& p, const Region& q) {
  std::size_t bits = 0;
  for (const Region* region : {&p, &q})
    for (const Chain* chain : chains_in(*region))
      for (const Point& v : *chain)
        for (const Rational* x : {&v.x, &v.y})
          bits = std::max(
              {bits, mpz_sizeinbase(x->get_num_mpz_t(), 2), mpz_sizeinbase(x->get_den_mpz_t(), 2)});
  constexpr std::size_t many = 1000;
  return "computing a sum of " + std::to_string(vertex_count(p)) + " and " +
         std::to_string(vertex_count(q)) + " vertices" +
         (bits > many ? " with coordinates of up to " + std::to_string(bits) + " bits" : "");
}

void add_certificate(const Command& command, std::optional<std::string>& certificate,
                     const std::string& what) {
  command.file(
      "--certificate", certificate,
      "write there what oplus-certified needs to check " + what + " (docs/certificates.md)");
}

void require_certifiable(const std::optional<std::string>& certificate,
                         const RegionOutput& output) {
  if (certificate && output_grid(output))
    throw UsageError("--certificate is for exact results, without --digits and --grid");
}

void add_open(const Command& command, Boundary& boundary, const std::string& what) {
  command.flag(
      "--open", [&boundary] { boundary = Boundary::open; }, what);
}

void add_spacing(const Command& command, SpacingOptions& spacing) {
  command.option(
      "--spacing D", spacing.distance,
      "keep Q at a distance: nfp is also where Q is nearer to P than D, and ifp only where it is not "
      "nearer than D to what is outside of P. By a polygon around the disc of radius D, so that Q is "
      "never nearer than D where it is allowed to be");
  command.option("--spacing-error E", spacing.error,
                 "by how much the polygon may be larger than the disc, D/100 by default");
}

std::optional<Region> disc_of(const SpacingOptions& spacing) {
  if (!spacing.distance) {
    if (spacing.error) throw UsageError("--spacing-error is for --spacing");
    return std::nullopt;
  }
  const Rational radius = positive_number("--spacing", "a distance", *spacing.distance);
  return disc_polygon(radius, DiscSide::outside,
                      spacing.error
                          ? positive_number("--spacing-error", "a distance", *spacing.error)
                          : Rational(radius / 100));
}

ReadSet spaced(const ReadSet& q, const Region& disc, const SumOf& sum) {
  const PlanarSet grown = result_of(operation_called("sum"), q, {disc, {}, {}, {}}, sum);
  return {region_of(grown), {}, {}, {}};
}

namespace {

ComputedSum by_oracle(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options) {
  OracleSums sums = oracle_sums(p, q);
  ComputedSum result;
  result.sum = std::move(boundary == Boundary::closed ? sums.closed : sums.open);
  if (options.with_origins) result.origins = origins(result.sum, reduced_convolution(p, q));
  result.statistics = {{"decided faces", sums.cells.faces},
                       {"decided edges", sums.cells.edges},
                       {"decided vertices", sums.cells.vertices}};
  return result;
}

}  // namespace

const std::vector<Engine>& engines_and_oracle() {
  static const std::vector<Engine> table = [] {
    std::vector<Engine> all = engines();
    all.push_back({.name = "oracle", .what = "the definitions, slowly", .compute = by_oracle});
    return all;
  }();
  return table;
}

}  // namespace oplus
