// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "checked/certificates/layout_certificate.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/layout_answer.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/layouts/reading.hpp"
#include "reference/definitions/region.hpp"

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
  std::optional<std::string> certificate;
  Answer answer = text_answer;
  std::string output = "-";
};

constexpr const char* certified_layouts =
    "--certificate is for layouts without --spacing, --margin and --tolerance, of one sheet without defects";

std::string certificate_of(const Sheet& sheet) {
  std::vector<Region> parts;
  for (const PlacedPart& part : sheet.parts) parts.push_back(translated(*part.shape, part.at));
  return certificates::layout_certificate(sheet.container, parts);
}

ExitCode check_layout(const LayoutOptions& options) {
  const LayoutRules rules{distance_number("--spacing", options.spacing),
                          distance_number("--margin", options.margin),
                          distance_number("--tolerance", options.tolerance)};
  const Rational error = angle_error(options.angle_error);
  require_one_standard_input(
      {options.layout, options.container.value_or(""), options.defects.value_or("")});
  std::vector<std::string> paths = {options.output};
  if (options.certificate) paths.push_back(*options.certificate);
  require_writable(paths);
  if (options.certificate && (rules.spacing != 0 || rules.margin != 0 || rules.tolerance != 0))
    throw UsageError(certified_layouts);
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
  if (options.certificate && (layout.sheets.size() != 1 || !layout.sheets[0].defects.empty()))
    throw UsageError(certified_layouts);
  Verdicts verdicts;
  for (const Sheet& sheet : layout.sheets)
    verdicts.push_back(check(sheet, rules, number_of(options.threads)));
  std::vector<OutputTo> outputs_to = {{options.output, options.answer(layout, verdicts)}};
  if (options.certificate && is_right(verdicts))
    outputs_to.emplace_back(*options.certificate, certificate_of(layout.sheets[0]));
  write_texts(outputs_to);
  if (options.certificate && !is_right(verdicts))
    say_note("there is no certificate of a layout that is wrong");
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
                         {{"text", text_answer},
                          {"json", json_answer},
                          {"svg", svg_answer},
                          {"wkt", wkt_answer},
                          {"container", container_answer}},
                         "answer in a text (the default), in JSON (docs/json.md), in a picture "
                         "in which wrong parts are red, or by the parts where they lie or the "
                         "container, in WKT, one a line");
  add_certificate(command, options.certificate, "a layout that is right");
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
