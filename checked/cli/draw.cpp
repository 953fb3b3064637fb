// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <filesystem>
#include <optional>

#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/input.hpp"
#include "checked/cli/layer_styles.hpp"
#include "checked/cli/numbers.hpp"
#include "checked/cli/shared_options.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/cli/view.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

struct DrawOptions {
  std::vector<std::string> files;
  std::optional<std::string> view;
  std::optional<std::string> at;
  bool together = false;
  Overlaps overlaps = Overlaps::refused;
  std::string output;
};

std::string view_names(const std::string& separator) {
  return joined(views(), &View::name, separator);
}

/// The view that is asked for, and its placement.
struct ChosenView {
  const View& view;
  Point x;
};

std::optional<ChosenView> chosen_view(const DrawOptions& options) {
  if (!options.view) {
    if (options.at) throw UsageError("--at goes with --view placement");
    return std::nullopt;
  }
  const View* view = find_view(*options.view);
  if (view == nullptr)
    throw UsageError("there is no view " + quote(*options.view) + "; there are " +
                     view_names(", "));
  if (options.files.size() != 2)
    throw UsageError("--view takes two files, P and Q, not " +
                     std::to_string(options.files.size()));
  if (view->has_a_placement != options.at.has_value())
    throw UsageError("--view " + view->name +
                     (options.at ? " takes no --at" : " needs --at X,Y, such as 1/3,2.5"));
  return ChosenView{*view, options.at ? pair_of_numbers("--at", *options.at) : Point{}};
}

/// A region, a sum or another set.
PlanarSet drawn_set(const std::string& file, Overlaps overlaps) {
  PlanarSet set = set_in(read_summand_set(file, nullptr, overlaps));
  if (set.is_unbounded)
    throw UsageError((file == "-" ? "standard input" : one_line(file)) +
                     ": the region is unbounded; expected a bounded one to draw");
  return set;
}

std::string side_by_side(const DrawOptions& options) {
  std::vector<Panel> panels;
  for (const std::string& file : options.files)
    panels.push_back(
        {file == "-" ? "standard input" : file, layers_of(drawn_set(file, options.overlaps))});
  return svg(panels);
}

/// The layers of a file in a picture with others, in a style by its place in the list.
std::vector<Layer> layers_in_common(std::size_t place, const std::string& name,
                                    const PlanarSet& sum) {
  const std::array<const Style*, 4> styles = {&style::sum, &style::summand_p, &style::summand_q,
                                              &style::common_interior};
  // Lines without a region are the content of the file; with one they are its dangling edges.
  const bool only_lines = sum.outer.empty();
  const Style lines = only_lines ? labelled(style::cycle(static_cast<int>((place + 6) % 7)), name)
                                 : labelled(style::dangling_edges, "dangling edges of " + name);
  const Style points =
      labelled(style::isolated_vertices, only_lines ? name : "isolated vertices of " + name);
  return {{labelled(*styles[place % styles.size()], name), region_of(sum)},
          {lines, {}, sum.dangling_edges},
          {points, {}, {}, sum.isolated_vertices}};
}

std::string one_over_the_other(const DrawOptions& options) {
  const std::vector<std::string>& files = options.files;
  Panel panel{"", {}};
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string name =
        files[i] == "-" ? "standard input" : std::filesystem::path(files[i]).stem().string();
    for (Layer& layer : layers_in_common(i, name, drawn_set(files[i], options.overlaps)))
      panel.layers.push_back(std::move(layer));
  }
  return svg({panel}, 560);
}

ExitCode draw(const DrawOptions& options) {
  const std::optional<ChosenView> chosen = chosen_view(options);
  require_one_standard_input(options.files);
  require_writable({}, options.output);
  if (!chosen) {
    write_text(options.output, (options.together ? one_over_the_other : side_by_side)(options));
    return ExitCode::done;
  }
  const Region p = read_summand(options.files[0], nullptr, Extent::bounded, options.overlaps);
  const Region q = read_summand(options.files[1], nullptr, Extent::bounded, options.overlaps);
  write_text(options.output, chosen->view.draw(p, q, chosen->x));
  return ExitCode::done;
}

std::string view_help() {
  return "draw what an algorithm sees of two regions P and Q: " +
         joined(
             views(), [](const View& view) { return view.name + ", " + view.what; }, "; ");
}

}  // namespace

void add_draw(Program& program) {
  const auto& [command, options] =
      program.add("draw", "Draw regions and sums, or what an algorithm sees of two regions", draw);
  command.file("FILE", options.files, "regions or sums (docs/files.md); - is standard input")
      .required();
  const Option view =
      command.option("--view NAME:{" + view_names(",") + "}", options.view, view_help());
  command
      .flag("--together", options.together,
            "draw all files over each other, the first at the bottom, not side by side")
      .excludes(view);
  add_union(command, options.overlaps, "each file");
  command.option(
      "--at X,Y", options.at,
      "the x of --view placement, which draws -Q + x: integers, decimals or fractions p/q");
  command
      .option("-o,--output FILE.svg", options.output,
              "the picture to write, an SVG; - is standard output")
      .required();
  command.footer(
      "Example:\n"
      "  oplus gen holes --n 8 --summand P -o p.wkt\n"
      "  oplus gen holes --n 8 --summand Q -o q.wkt\n"
      "  oplus draw p.wkt q.wkt -o both.svg\n"
      "  oplus draw p.wkt q.wkt --together -o one_over_the_other.svg\n"
      "  oplus draw p.wkt q.wkt --view winding -o winding.svg\n"
      "  oplus draw p.wkt q.wkt --view placement --at 1/3,-2.5 -o placement.svg");
}

}  // namespace oplus
