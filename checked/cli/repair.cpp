// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/repair/repair.hpp"

#include <optional>
#include <string>

#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/json_values.hpp"
#include "checked/cli/shared_options.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

struct RepairOptions {
  std::string file;
  RegionOutput output;
  std::optional<FillRule> fill;
  bool json = false;
};

std::string name_of(MendKind kind) {
  switch (kind) {
    case MendKind::closed_ring:
      return "closed ring";
    case MendKind::repeated_vertex:
      return "repeated vertex";
    case MendKind::spike:
      return "spike";
    case MendKind::empty_chain:
      return "empty chain";
    case MendKind::role:
      return "role";
    case MendKind::orientation:
      return "orientation";
    case MendKind::filled:
      return "filled";
  }
  return "";
}

std::string place_of(const Place& place) {
  return one_line(place.file) + ":" + std::to_string(place.line) + ":" +
         std::to_string(place.column);
}

std::string json_of(const std::vector<Mend>& mends) {
  Json all = Json::array();
  for (const Mend& mend : mends)
    all.push_back({{"kind", name_of(mend.kind)},
                   {"line", mend.where.line},
                   {"column", mend.where.column},
                   {"what", mend.what}});
  return Json{{"count", mends.size()}, {"mends", all}}.dump(2) + "\n";
}

ExitCode repair(const RepairOptions& options) {
  std::vector<std::string> outputs = {options.output.path};
  if (options.json) outputs.emplace_back("-");
  require_writable(outputs);
  const Format format = output_format(options.output);
  UncheckedInput input = read_unchecked_region(options.file);
  const std::string name = one_line(input.name);
  const RepairedRegion result = repaired(std::move(input), options.fill);
  std::vector<OutputTo> others;
  if (options.json) others.emplace_back("-", json_of(result.mends));
  write_output(options.output, output_text(options.output, format, result.region),
               std::move(others));
  for (const Mend& mend : result.mends) say_note(place_of(mend.where) + ": " + mend.what);
  say_note(name + ": " +
           (result.mends.empty() ? "nothing to repair"
                                 : counted(result.mends.size(), "repair", "repairs")));
  return ExitCode::done;
}

}  // namespace

void add_repair(Program& program) {
  const auto& [command, options] = program.add(
      "repair",
      "Mend a region: repeated vertices, spikes, open rings, orientation; say what was done",
      repair);
  command
      .file("R", options.file,
            "what is to be a region: WKT, GeoJSON, .dat or SVG path data; - is standard input")
      .required();
  add_output(command, options.output, "the region");
  command.choice<FillRule>(
      "--fill RULE", options.fill,
      {{"even-odd", FillRule::even_odd}, {"nonzero", FillRule::nonzero}},
      "make a region of chains that cross or overlap too: even-odd, the points around which they "
      "wind an odd number of times; nonzero, all around which they wind, outer chains "
      "counterclockwise and holes clockwise. By default such chains are refused");
  command.flag("--json", options.json,
               "print what was done in JSON (docs/json.md); needs --output");
  command.footer(
      "What is done is a line each on standard error, with the place in the input (docs/files.md).\n"
      "\n"
      "Example:\n"
      "  oplus gen tight --n 6 --summand P -o part.wkt\n"
      "  oplus repair part.wkt -o mended.wkt\n"
      "  oplus repair part.wkt -o mended.wkt --fill nonzero --json\n"
      "  oplus sum mended.wkt mended.wkt -o sum.wkt");
}

}  // namespace oplus
