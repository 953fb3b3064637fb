// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/format_option.hpp"

#include <map>
#include <string>

namespace oplus {

void add_format_option(CLI::App& subcommand, std::optional<Format>& format) {
  static const std::map<std::string, Format> formats = {
      {"wkt", Format::wkt}, {"dat", Format::dat}, {"geojson", Format::geojson}};
  subcommand
      .add_option_function<std::string>(
          "--format", [&format](const std::string& name) { format = formats.at(name); },
          "write wkt, dat or geojson; without it the ending of FILE decides, and wkt on standard "
          "output")
      ->check(CLI::IsMember(formats))
      ->type_name("NAME");
}

}  // namespace oplus
