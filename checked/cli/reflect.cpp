// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/input.hpp"
#include "checked/cli/shared_options.hpp"

namespace oplus {

namespace {

struct ReflectOptions {
  std::string file;
  Overlaps overlaps = Overlaps::refused;
  RegionOutput output;
};

ExitCode reflect(const ReflectOptions& options) {
  require_writable({options.output.path});
  const Format format = output_format(options.output);
  write_region(options.output, format,
               reflected(read_summand(options.file, nullptr, Extent::any, options.overlaps)));
  return ExitCode::done;
}

}  // namespace

void add_reflect(CLI::App& program, Action& chosen) {
  const auto& [command, options] = add_subcommand(
      program, chosen, "reflect", "Write -R, each point p of a region R taken to -p", reflect);
  add_file(command, "R", options.file,
           "a region: .dat, WKT, GeoJSON or an SVG path (docs/files.md); - is standard input")
      ->required();
  add_output(command, options.output, "-R");
  add_union(command, options.overlaps, "R");
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
