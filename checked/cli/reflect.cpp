// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/program_frame.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/output.hpp"
#include "checked/cli/shared_options.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct ReflectOptions {
  std::string file;
  std::string output = "-";
  std::optional<Format> format;
};

ExitCode reflect(const ReflectOptions& options) {
  require_writable({options.output});
  const Format format = output_format(options.format, options.output);
  write_text(options.output, written(reflected(read_summand(options.file)), format));
  return ExitCode::done;
}

}  // namespace

void add_reflect(CLI::App& program, Action& chosen) {
  const auto& [command, options] = add_subcommand(
      program, chosen, "reflect", "Write -R, each point p of a region R taken to -p", reflect);
  add_file(command, "R", options.file, "a region: .dat, WKT or GeoJSON; - is standard input")
      ->required();
  add_file(command, "-o,--output", options.output, "write it there, not to standard output");
  add_format(command, options.format);
  command.footer(
      "Where R, moved by x, overlaps P: that are the x inside the sum of P and -R, the no-fit polygon\n"
      "of P and R.\n"
      "\n"
      "Example:\n"
      "  oplus gen tight --n 6 --summand P -o part.wkt\n"
      "  oplus gen tight --n 6 --summand Q -o other.wkt\n"
      "  oplus reflect other.wkt | oplus sum part.wkt - --open -o no_fit.wkt");
}

}  // namespace oplus
