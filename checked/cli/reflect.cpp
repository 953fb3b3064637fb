// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "checked/cli/input.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/operations/image.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

namespace {

struct ReflectOptions {
  std::string file;
  Overlaps overlaps = Overlaps::refused;
  RegionOutput output;
  Boundary boundary = Boundary::closed;  ///< of the set, for rounding
};

ExitCode reflect(const ReflectOptions& options) {
  require_writable({options.output.path});
  const Format format = output_format(options.output);
  ReadSet read = read_summand_set(options.file, nullptr, options.overlaps);
  // What is closed by itself: of an open set, rounding may leave edges and points.
  if (is_region(read) && options.boundary == Boundary::closed) {
    write_region(options.output, format, reflected(std::move(read.region)));
    return ExitCode::done;
  }
  const MinkowskiSum set = image(scaling(-1), set_in(read));
  write_output(options.output,
               output_text(options.output, format, set, region_of(set), options.boundary));
  return ExitCode::done;
}

}  // namespace

void add_reflect(Program& program) {
  const auto& [command, options] = program.add(
      "reflect", "Write -R, each point p of a region or another set R taken to -p", reflect);
  command
      .file(
          "R", options.file,
          "a region or a sum (docs/files.md), also line strings, points, and collections of all three; "
          "- is standard input")
      .required();
  add_output(command, options.output, "-R");
  add_union(command, options.overlaps, "R");
  add_open_set(command, options.boundary);
  command.footer(
      "R, moved by x, overlaps P if and only if x is inside the sum of P and -R, the no-fit polygon of\n"
      "P and R.\n"
      "\n"
      "Example:\n"
      "  oplus gen tight --n 6 --summand P -o part.wkt\n"
      "  oplus gen tight --n 6 --summand Q -o other.wkt\n"
      "  oplus reflect other.wkt | oplus sum part.wkt - --open -o no_fit.wkt");
}

}  // namespace oplus
