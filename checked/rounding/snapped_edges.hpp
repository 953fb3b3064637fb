// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "checked/rounding/faces.hpp"
#include "checked/rounding/snap_rounding.hpp"

namespace oplus {

/// A part of an edge's polyline, from one hot pixel to the next.
struct Link {
  NumberedEdge between;  ///< centres, from the smaller one
  std::uint32_t edge;    ///< by its index
  bool forth;            ///< whether the edge runs so
};

/// The boundary of a set, the set to the left, after snap rounding. Where as many edges run along a link forth as back, a part of
/// the set or of its complement became thin, and none is left; else one is (docs/rounding.md). Points are named by the
/// numbers of centres.
struct SnappedEdges {
  SnappedEdges(const Boundaries& set, const HotPixels& hot);

  std::vector<Link> links;  ///< sorted by `between`
  std::vector<NumberedEdge>
      left;  ///< of the new boundary, the set to their left; they meet at ends only
  std::vector<NumberedEdge> thin;     ///< where there are links, and none is left
  std::vector<std::uint32_t> points;  ///< of edges that became points
};

/// Calls visit(group) with those between the same centres. Requires: links are sorted.
template <typename Visit>
void each_group(std::span<const Link> links, const Visit& visit) {
  for (std::size_t first = 0, last = 0; first < links.size(); first = last) {
    while (last < links.size() && links[last].between == links[first].between) ++last;
    visit(links.subspan(first, last - first));
  }
}

/// How many more edges run along a link forth than back: 1, 0 or -1.
int turns(std::span<const Link> group);

}  // namespace oplus
