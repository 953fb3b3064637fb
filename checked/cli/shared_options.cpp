// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/shared_options.hpp"

#include <map>

namespace oplus {

void add_output(CLI::App& command, RegionOutput& output, const std::string& what) {
  add_file(command, "-o,--output", output.path,
           "write " + what + " there; by default to standard output");
  static const std::map<std::string, Format> formats = {
      {"wkt", Format::wkt}, {"dat", Format::dat}, {"geojson", Format::geojson}};
  command
      .add_option_function<std::string>(
          "--format", [&output](const std::string& name) { output.format = formats.at(name); },
          "write wkt, dat or geojson; by default what the ending of FILE says, and wkt on standard "
          "output")
      ->check(CLI::IsMember(formats))
      ->type_name("NAME");
  command
      .add_option("--digits", output.digits,
                  "round to N decimals; by default the output is exact, with fractions p/q where a "
                  "decimal would not end")
      ->check(CLI::Range(0, most_digits))
      ->type_name("N");
}

void add_open(CLI::App& command, Boundary& boundary, const std::string& what) {
  command.add_flag_callback(
      "--open", [&boundary] { boundary = Boundary::open; }, what);
}

}  // namespace oplus
