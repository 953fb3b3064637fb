// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/values.hpp"

namespace oplus {

/// Where points lie with respect to an open set, for many points. (A sweep passes over the edges from left to
/// right; the tree of those that it meets is kept as it was at each place: Sarnak and Tarjan's planar point
/// location. Trees share what they have in common. They are treaps, whose priorities depend on the edge alone.)
/// For n edges and points: built in O(n log n), with as much memory.
class PointLocation {
 public:
  /// Requires: the set is in canonical form.
  explicit PointLocation(const PlanarSet& open_set);

  /// As locate (difference.hpp): dangling edges and isolated vertices are on the boundary. Exact. O(log n).
  Location locate(const Point& x) const;

 private:
  using Index = std::uint32_t;
  static constexpr Index none = ~Index{0};

  /// A tree, of edges from the lowest to the highest.
  struct Node {
    Index edge;
    Index lower, higher;
  };

  struct Edge {
    IntervalSegment near;
    Segment exact;         ///< from its lexicographically smaller end
    bool is_below_inside;  ///< whether what is directly above it is inside
  };

  /// At which edges begin, end or touch, or an isolated vertex.
  struct Place {
    IntervalPoint near;
    Point exact;
    Index above;  ///< the tree of the edges that are met between this place and the next one
  };

  Index add(const Node& node);
  template <typename Belongs>
  std::pair<Index, Index> split(Index tree, const Belongs& belongs_below);
  Index joined(Index lower, Index higher);

  std::vector<Edge> edges_;
  std::vector<Node> nodes_;
  std::vector<Place> places_;  ///< lexicographically sorted
  bool is_unbounded_;
};

}  // namespace oplus
