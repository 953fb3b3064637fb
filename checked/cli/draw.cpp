// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "checked/cli/input.hpp"
#include "checked/cli/output.hpp"
#include "checked/cli/subcommands.hpp"
#include "reference/io/picture.hpp"

namespace oplus {

namespace {

struct DrawOptions {
  std::vector<std::string> files;
  std::string output;
};

ExitCode draw(const DrawOptions& options) {
  require_one_standard_input(options.files);
  require_writable({options.output});
  std::vector<Panel> panels;
  for (const std::string& file : options.files)
    panels.push_back({file == "-" ? "standard input" : file, layers_of(read_given_sum(file))});
  write_output(options.output, svg(panels));
  return ExitCode::done;
}

}  // namespace

void add_draw(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<DrawOptions>();
  CLI::App& command = *program.add_subcommand("draw", "Draw regions and sums side by side");
  command.add_option("FILE", options->files, "regions or sums; - is standard input")
      ->required()
      ->type_name("FILE");
  command.add_option("-o,--output", options->output, "the picture, SVG; - is standard output")
      ->required()
      ->type_name("FILE.svg");
  command.footer(
      "Example:\n"
      "  oplus gen holes --n 8 --summand P -o p.wkt\n"
      "  oplus gen holes --n 8 --summand Q -o q.wkt\n"
      "  oplus draw p.wkt q.wkt -o both.svg");
  command.callback([options, &chosen] { chosen = [options] { return draw(*options); }; });
}

}  // namespace oplus
