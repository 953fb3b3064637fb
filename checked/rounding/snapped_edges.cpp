// SPDX-License-Identifier: MIT
#include "checked/rounding/snapped_edges.hpp"

#include <algorithm>

namespace oplus {

SnappedEdges::SnappedEdges(const Boundaries& set, const HotPixels& hot) {
  links.reserve(set.edges.size());
  for (std::uint32_t i = 0; i < set.edges.size(); ++i) {
    const auto& [source, target, on_left, on_right] = set.edges[i];
    const std::vector<std::uint32_t> passed = hot.numbers_passed(*source, *target);
    for (std::size_t k = 1; k < passed.size(); ++k) {
      const auto [from, to] = std::minmax(passed[k - 1], passed[k]);
      links.push_back({{from, to}, i, passed[k - 1] < passed[k]});
    }
    if (passed.size() == 1) points.push_back(passed.front());
  }
  std::ranges::sort(links, {}, &Link::between);
  each_group(links, [&](std::span<const Link> group) {
    const auto [from, to] = group.front().between;
    const int more = turns(group);
    if (more == 0)
      thin.push_back({from, to});
    else
      left.push_back(more > 0 ? NumberedEdge{from, to} : NumberedEdge{to, from});
  });
}

int turns(std::span<const Link> group) {
  int result = 0;
  for (const Link& one : group) result += one.forth ? 1 : -1;
  return result;
}

}  // namespace oplus
