// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/recorded_pictures.hpp"

#include <algorithm>
#include <map>

#include "checked/arrangement/rca.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/io/writing.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

namespace {

namespace fs = std::filesystem;

/// There a point is marked.
std::string picture_of_pair(const Summands& pair, const std::optional<Point>& marked = {}) {
  std::vector<Layer> layers = layers_of(rca(pair.p, pair.q, Boundary::open).sum);
  // Over the region, below dangling edges and isolated vertices.
  const auto above_region = std::find_if_not(layers.begin(), layers.end(), [](const Layer& layer) {
    return !layer.region.components.empty();
  });
  layers.insert(above_region, {style::convolution, {}, segments(convolution(pair.p, pair.q))});
  if (marked)
    layers.push_back({labelled(style::difference, "where the statement fails"), {}, {}, {*marked}});
  return svg({panel_of(Summand::P, pair.p),
              panel_of(Summand::Q, pair.q),
              {"Convolution and open sum", std::move(layers)}});
}

void write_pictures(const fs::path& record, const std::string& ending,
                    const std::map<std::string, std::string>& pictures) {
  const fs::path folder = record.parent_path() / "pictures";
  fs::create_directories(folder);
  for (const auto& file : fs::directory_iterator(folder))
    if (file.path().string().ends_with(ending)) fs::remove(file);
  for (const auto& [id, picture] : pictures) write_file((folder / (id + ending)).string(), picture);
}

}  // namespace

void draw_beside(const fs::path& record, const std::vector<PropertyRun>& runs) {
  std::map<std::string, std::string> pictures;
  for (const PropertyRun& run : runs)
    if (run.typical) pictures.emplace(run.statement, picture_of_pair(*run.typical));
  write_pictures(record, "-typical.svg", pictures);
}

void draw_beside(const fs::path& record, const std::vector<Kill>& kills) {
  std::map<std::string, std::string> pictures;
  for (const Kill& kill : kills)
    if (kill.shrunk && !pictures.contains(kill.statement))
      pictures.emplace(kill.statement, picture_of_pair(*kill.shrunk, kill.at));
  write_pictures(record, "-shrunk.svg", pictures);
}

}  // namespace oplus
