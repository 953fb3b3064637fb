// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/set_panel.hpp"

#include <boost/algorithm/string/join.hpp>
#include <string>
#include <vector>

#include "reference/chains/region_of.hpp"
#include "reference/io/counted.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

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
