// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// A binary tree of axis-aligned boxes around segments: each node's segments are halved by the
/// middles of their boxes along the longer side (thesis, Section 5.1.2). The boxes are certified
/// intervals, so no box is too small.
class BoundingVolumeHierarchy {
 public:
  explicit BoundingVolumeHierarchy(const std::vector<Segment>& segments);
  ~BoundingVolumeHierarchy();

  bool empty() const;

  /// Calls `visit(i, j)` for segment i of this hierarchy and segment j of `moved` wherever their
  /// boxes meet, `moved` translated by `by`, until a call returns true. Returns whether one did.
  bool visit_meeting(const BoundingVolumeHierarchy& moved, const Vector& by,
                     const std::function<bool(std::size_t i, std::size_t j)>& visit) const;

 private:
  struct Box;
  struct Node;
  struct Leaf;

  void build(std::vector<Leaf>& leaves, std::size_t begin, std::size_t end);

  std::vector<Node> nodes_;
};

}  // namespace oplus
