// SPDX-License-Identifier: MIT
#include "checked/rounding/snapped_edges.hpp"

#include <algorithm>
#include <utility>

#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

SnappedEdges::SnappedEdges(const std::vector<Segment>& edges, const HotPixels& hot) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::vector<Point> passed = hot.passed(edges[i]);
    for (std::size_t k = 1; k < passed.size(); ++k) {
      const bool forth = passed[k - 1] < passed[k];
      links.push_back(
          {forth ? Segment{passed[k - 1], passed[k]} : Segment{passed[k], passed[k - 1]}, forth,
           i});
    }
    points.push_back(passed.front());
  }
  std::ranges::sort(links, {}, &Link::segment);
  std::vector<Point> ends;
  // Emscripten's library makes a span of pointers only.
  for (const Link *first = links.data(), *const end = first + links.size(); first != end;) {
    const Link* last =
        std::find_if(first, end, [&](const Link& one) { return one.segment != first->segment; });
    groups.emplace_back(first, last);
    const int more = turns(groups.back());
    if (more == 0)
      thin.push_back(first->segment);
    else
      left.push_back(more > 0 ? first->segment : reversed(first->segment));
    ends.push_back(first->segment.source);
    ends.push_back(first->segment.target);
    first = last;
  }
  ends = sorted_without_copies(std::move(ends));
  std::erase_if(points, [&](const Point& p) { return std::ranges::binary_search(ends, p); });
}

int turns(std::span<const Link> group) {
  int result = 0;
  for (const Link& one : group) result += one.forth ? 1 : -1;
  return result;
}

}  // namespace oplus
