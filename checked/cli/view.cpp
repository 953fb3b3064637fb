// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/view.hpp"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <string>
#include <utility>
#include <vector>

#include "reference/chains/region_of.hpp"
#include "reference/io/counted.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

namespace {

template <std::string (*draw)(const Region&, const Region&)>
std::string without_placement(const Region& p, const Region& q, const Point& /*x*/) {
  return draw(p, q);
}

}  // namespace

const std::vector<View>& views() {
  static const std::vector<View> table = {
      {"fiber-grid", "the states of each pair of chains, convolution segments as edges", false,
       without_placement<fiber_grid_view>},
      {"cycles", "the convolution in the colours of its cycles", false,
       without_placement<cycles_view>},
      {"faces", "the reduced convolution's faces, candidates and holes", false,
       without_placement<faces_view>},
      {"slide", "the reduced convolution and the sum that its free pieces bound", false,
       without_placement<slide_view>},
      {"loops", "the reduced convolution's orientable loops, and what becomes of each", false,
       without_placement<loops_view>},
      {"winding", "the winding numbers of the convolution", false, without_placement<winding_view>},
      {"original", "the original convolution and its winding numbers", false,
       without_placement<original_view>},
      {"placement", "P and -Q + x with their contacts, x from --at", true, placement_view},
  };
  return table;
}

const View* find_view(const std::string& name) {
  const auto found = std::find_if(views().begin(), views().end(),
                                  [&](const View& view) { return view.name == name; });
  return found == views().end() ? nullptr : &*found;
}

std::string beside_summands(const Region& p, const Region& q, std::string title,
                            std::vector<Layer> layers) {
  constexpr double longest_side = 560;
  return svg_in_columns(
      {{panel_of(Summand::P, p), panel_of(Summand::Q, q)}, {{std::move(title), std::move(layers)}}},
      longest_side);
}

Panel panel_of_set(Summand which, const PlanarSet& set) {
  const Style& style = which == Summand::P ? style::summand_p : style::summand_q;
  Style of_points = style;
  of_points.fill = style.line;
  const Region region = region_of(set);
  std::vector<std::string> sizes;
  const auto add = [&](std::size_t size, const char* one, const char* several) {
    if (size > 0) sizes.push_back(counted(size, one, several));
  };
  add(vertex_count(region), "vertex", "vertices");
  add(set.dangling_edges.size(), "segment", "segments");
  add(set.isolated_vertices.size(), "point", "points");
  return {style.label + ": " + (sizes.empty() ? "empty" : boost::algorithm::join(sizes, ", ")),
          {{style, region, set.dangling_edges}, {of_points, {}, {}, set.isolated_vertices}}};
}

}  // namespace oplus
