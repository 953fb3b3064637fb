// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/layout_answer.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/layouts/reading.hpp"

namespace oplus {

namespace {

using Answer = std::string (*)(const Layout& layout, const Verdicts& verdicts);

struct LayoutOptions {
  std::string layout;
  std::optional<std::string> container;
  std::optional<std::string> defects;
  std::string spacing = "0";
  std::string margin = "0";
  std::string tolerance = "0";
  std::string angle_error = "0.000000001";
  std::optional<unsigned> threads;
  Answer answer = text_answer;
  std::string output = "-";
};

ExitCode check_layout(const LayoutOptions& options) {
  const LayoutRules rules{distance_number("--spacing", options.spacing),
                          distance_number("--margin", options.margin),
                          distance_number("--tolerance", options.tolerance)};
  const Rational error = angle_error(options.angle_error);
  require_one_standard_input(
      {options.layout, options.container.value_or(""), options.defects.value_or("")});
  require_writable({options.output});
  Layout layout = read_layout_file(options.layout, error);
  for (const std::string& note : layout.notes) say_note(note);
  if (options.container) {
    const Region container = read_summand(*options.container);
    for (Sheet& sheet : layout.sheets) {
      sheet.container = container;
      sheet.defects.clear();
    }
  }
  if (options.defects) {
    const Region defects =
        read_summand(*options.defects, nullptr, Extent::bounded, Overlaps::allowed);
    for (Sheet& sheet : layout.sheets) sheet.defects.push_back({defects});
  }
  Verdicts verdicts;
  for (const Sheet& sheet : layout.sheets)
    verdicts.push_back(check(sheet, rules, number_of(options.threads)));
  write_text(options.output, options.answer(layout, verdicts));
  return is_right(verdicts) ? ExitCode::done : ExitCode::not_equal;
}

}  // namespace

void add_layout(Program& program) {
  const auto& [command, options] = program.add(
      "layout", "Check whether parts of a layout overlap, leave their container or are too near",
      check_layout);
  command
      .file("LAYOUT", options.layout,
            "polygons where they lie, JSON with parts and placements, JSON of jagua-rs, sparrow or "
            "packingsolver, or SVG (docs/layouts.md); - is standard input")
      .required();
  command.file("--container", options.container,
               "what the parts must lie in, instead of what LAYOUT says; a region "
               "(docs/files.md), on whose holes no part may lie");
  command.file("--defects", options.defects,
               "on which no part may lie, besides; polygons, which may overlap");
  command.option("--spacing D", options.spacing, "parts are to be at least D from each other")
      .default_shown();
  command
      .option("--margin D", options.margin,
              "parts are to be at least D from the container's edge, its holes and defects")
      .default_shown();
  command
      .option("--tolerance D", options.tolerance,
              "forgive overlaps that a move by at most D ends, exactly; also with what is outside "
              "of the container")
      .default_shown();
  command
      .option("--angle-error E", options.angle_error,
              "rotations by other than multiples of 90 degrees are taken for one by at most E "
              "degrees more or less, as by 'oplus transform'")
      .default_shown();
  add_threads(command, options.threads, "");
  command.choice<Answer>("--format", options.answer,
                         {{"text", text_answer}, {"json", json_answer}, {"svg", svg_answer}},
                         "answer in a text (the default), in JSON (docs/json.md), or in a picture "
                         "in which wrong parts are red");
  command.file("-o,--output", options.output,
               "write the answer there; by default to standard output");
  command.footer(
      "Touching is allowed. Everything is decided exactly, for the coordinates as they are written.\n"
      "\n"
      "Example:\n"
      "  oplus gen star --n 8 --summand P -o parts.wkt\n"
      "  oplus layout parts.wkt\n"
      "  oplus layout parts.wkt --format json\n"
      "  oplus layout parts.wkt --format svg -o parts.svg\n"
      "\n"
      "Exit codes:\n"
      "  0  the layout is right\n"
      "  1  it is wrong\n"
      "  2  invalid input or usage");
}

}  // namespace oplus
