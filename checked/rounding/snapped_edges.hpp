// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "checked/rounding/snap_rounding.hpp"

namespace oplus {

/// A part of an edge's polyline, from one hot pixel to the next.
struct Link {
  Segment segment;   ///< from its smaller end
  bool forth;        ///< whether the edge runs so
  std::size_t edge;  ///< by its index
};

/// The boundary of a set, the set to the left, after snap rounding. Where as many edges run along a link forth as back, a part of
/// the set or of its complement became thin, and none is left; else one is (docs/rounding.md).
struct SnappedEdges {
  SnappedEdges(const std::vector<Segment>& edges, const HotPixels& hot);

  std::vector<Link> links;                    ///< sorted by their segments
  std::vector<std::span<const Link>> groups;  ///< those with the same segment
  std::vector<Segment>
      left;  ///< of the new boundary, the set to their left; they meet at ends only
  std::vector<Segment> thin;  ///< segments of groups of which none is left
  std::vector<Point> points;  ///< of edges that became points, where no link ends

  SnappedEdges(const SnappedEdges&) = delete;
  SnappedEdges& operator=(const SnappedEdges&) = delete;
};

/// How many more edges run along a link forth than back: 1, 0 or -1.
int turns(std::span<const Link> group);

}  // namespace oplus
