// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/disc.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct DiscOptions {
  std::string radius;
  std::string error;
  bool inside = false;
  bool outside = false;
  RegionOutput output;
};

ExitCode write_disc(const DiscOptions& options) {
  if (options.inside == options.outside) throw UsageError("give one of --inside and --outside");
  require_writable({options.output.path});
  const Format format = output_format(options.output);
  const Region region = disc_polygon(number("--radius", options.radius),
                                     options.inside ? DiscSide::inside : DiscSide::outside,
                                     number("--error", options.error));
  RegionOutput output = options.output;
  // What is rounded stays on the side that was asked for.
  if (output_grid(output) && !output.side)
    output.side = options.inside ? Side::contained : Side::contain;
  write_region(output, format, region);
  say_note("a polygon of " + counted(vertex_count(region), "vertex", "vertices") +
           (options.inside ? " inside the disc" : " around the disc"));
  return ExitCode::done;
}

}  // namespace

void add_disc(Program& program) {
  const auto& [command, options] =
      program.add("disc", "Write a polygon inside or around a disc about the origin", write_disc);
  command.option("--radius R", options.radius, "the radius: an integer, a decimal or p/q")
      .required();
  command.flag("--inside", options.inside, "write a polygon that the disc contains");
  command.flag("--outside", options.outside, "write a polygon that contains the disc");
  command
      .option(
          "--error E", options.error,
          "each point of the disc, with --outside each point of the polygon, is at most E away from the "
          "other; decided exactly")
      .required();
  add_output(command, options.output, "the polygon");
  command.footer(
      "The polygon has about 2.2 times the square root of R/E vertices, at most a tenth more than\n"
      "necessary and up to 8. Its coordinates are short decimals. The sum of a region and --inside\n"
      "contains only points at most R away from the region, that with --outside contains all of them.\n"
      "\n"
      "Example:\n"
      "  oplus gen star --n 8 --summand P -o p.wkt\n"
      "  oplus disc --radius 20 --outside --error 0.5 | oplus sum p.wkt - -o offset.wkt\n"
      "  oplus disc --radius 5/2 --inside --error 1e-3 --format dat -o disc.dat");
}

}  // namespace oplus
