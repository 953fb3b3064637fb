// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/shared_options.hpp"

#include <map>

namespace oplus {

void add_format(CLI::App& command, std::optional<Format>& format) {
  static const std::map<std::string, Format> formats = {
      {"wkt", Format::wkt}, {"dat", Format::dat}, {"geojson", Format::geojson}};
  command
      .add_option_function<std::string>(
          "--format", [&format](const std::string& name) { format = formats.at(name); },
          "write wkt, dat or geojson; without it the ending of FILE decides, and wkt on standard "
          "output")
      ->check(CLI::IsMember(formats))
      ->type_name("NAME");
}

void add_open(CLI::App& command, Boundary& boundary, const std::string& what) {
  command.add_flag_callback(
      "--open", [&boundary] { boundary = Boundary::open; }, what);
}

}  // namespace oplus
