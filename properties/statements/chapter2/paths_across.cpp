// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter2/paths_across.hpp"

#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/exact_box.hpp"

namespace oplus {

std::vector<std::vector<Segment>> paths_across(const Summands& summands) {
  const std::vector<Segment> all = segments(vertex_edge_sum(summands.p, summands.q));
  const auto [low, high] = box_around(all).enlarged(1);
  // Horizontal and vertical lines through sums of vertices, and two slanted ones, which hardly ever
  // pass through one.
  std::vector<Segment> paths = {{low, high}, {{low.x, high.y}, {high.x + Rational(1, 7), low.y}}};
  for (const std::size_t k : {all.size() / 3, 2 * all.size() / 3}) {
    const Point& through = all[k].source;
    paths.push_back({{low.x, through.y}, {high.x, through.y}});
    paths.push_back({{through.x, low.y}, {through.x, high.y}});
  }
  std::vector<std::vector<Segment>> result;
  for (const Segment& path : paths) result.push_back(cut_where_met(path, all));
  return result;
}

}  // namespace oplus
