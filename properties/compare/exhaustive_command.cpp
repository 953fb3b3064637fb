// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/commands.hpp"
#include "properties/compare/compare.hpp"
#include "properties/compare/sources.hpp"

namespace oplus {

namespace {

struct Settings : CompareOptions {
  int side = 3;
  std::size_t most_vertices = 4;
};

int exhaustive(const Settings& settings) {
  return compare("exhaustive", settings, {grid_source(settings.side, settings.most_vertices)});
}

}  // namespace

void add_exhaustive_command(Program& program) {
  const auto& [command, settings] = program.add(
      "exhaustive",
      "Compare engines with the oracle, or with sums of convex parts, on every pair of small grid polygons",
      exhaustive);
  command.option("--grid", settings.side, "Points along a side of the grid")
      .range(2, 16)
      .default_shown();
  command.option("--vertices", settings.most_vertices, "The most vertices of a polygon")
      .range(3, 16)
      .default_shown();
  add_engine_option(command, settings, "The engine to check; may be repeated");
  add_shrink_option(command, settings.campaign);
  add_run_options(command, settings);
  command.footer(
      "Of pairs that differ by exchange, translations or symmetries of the square one is compared.\n"
      "\n"
      "Example:\n"
      "  oplus-check exhaustive --grid 3 --vertices 5 --shard 1/4 --resume part1.json\n"
      "\n"
      "Exit codes:\n"
      "  0  all agree\n"
      "  1  a disagreement\n"
      "  2  invalid input or usage, or a file that cannot be read or written\n"
      "  5  interrupted by SIGINT or SIGTERM; the reports contain what was compared until then, and with\n"
      "     --resume the same command goes on. A second signal ends the program at once");
}

}  // namespace oplus
