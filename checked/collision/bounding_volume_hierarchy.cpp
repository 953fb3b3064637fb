// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/bounding_volume_hierarchy.hpp"

#include <algorithm>

namespace oplus {

namespace {

Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}

Box box_of(const Segment& s) {
  const IntervalPoint source = interval(s.source);
  const IntervalPoint target = interval(s.target);
  return {hull(source.x, target.x), hull(source.y, target.y)};
}

/// Where a box goes in the order along an axis; only the shape of the tree depends on it.
double middle(const Interval& side) { return side.inf() / 2 + side.sup() / 2; }

}  // namespace

BoundingVolumeHierarchy::BoundingVolumeHierarchy(const std::vector<Segment>& segments) {
  std::vector<std::pair<Box, std::size_t>> boxes;
  boxes.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) boxes.emplace_back(box_of(segments[i]), i);
  nodes_.reserve(2 * segments.size());
  if (!boxes.empty()) build(boxes, 0, boxes.size());
}

void BoundingVolumeHierarchy::build(std::vector<std::pair<Box, std::size_t>>& boxes,
                                    std::size_t begin, std::size_t end) {
  Box around = boxes[begin].first;
  for (std::size_t i = begin + 1; i < end; ++i)
    around = {hull(around.x, boxes[i].first.x), hull(around.y, boxes[i].first.y)};
  const std::size_t self = nodes_.size();
  nodes_.push_back({around, 0, boxes[begin].second});
  if (end - begin == 1) return;
  const bool wide = around.x.sup() - around.x.inf() > around.y.sup() - around.y.inf();
  const std::size_t half = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return boxes.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(half), at(end), [&](const auto& a, const auto& b) {
    return wide ? middle(a.first.x) < middle(b.first.x) : middle(a.first.y) < middle(b.first.y);
  });
  build(boxes, begin, half);
  nodes_[self].right = nodes_.size();
  build(boxes, half, end);
}

}  // namespace oplus
