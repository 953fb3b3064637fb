// SPDX-License-Identifier: MIT
#include "reference/chains/frame.hpp"

#include <algorithm>
#include <optional>

#include "reference/definitions/contract.hpp"

namespace oplus {

namespace {

/// The smallest box around points, its sides parallel to the axes.
class Box {
 public:
  void add(const Point& p) {
    if (!corners_) {
      corners_ = Segment{p, p};
      return;
    }
    auto& [low, high] = *corners_;
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }

  Rational extent() const {
    if (!corners_) return 0;
    const Vector diagonal = direction_of(*corners_);
    return std::max(diagonal.x, diagonal.y);
  }

  /// The corners of the box that is larger on each side, from the lower left one counterclockwise.
  Chain enlarged(const Rational& margin) const {
    OPLUS_REQUIRES(margin > 0, "framed");
    const Segment corners = corners_.value_or(Segment{{0, 0}, {0, 0}});
    const Point low = corners.source - Vector{margin, margin};
    const Point high = corners.target + Vector{margin, margin};
    return {low, {high.x, low.y}, high, {low.x, high.y}};
  }

 private:
  std::optional<Segment> corners_;
};

Box box_around(const Region& region) {
  Box box;
  for (const Component& component : region.components) {
    for (const Point& p : component.outer) box.add(p);
    for (const Chain& hole : component.holes)
      for (const Point& p : hole) box.add(p);
  }
  return box;
}

Box box_around(const PlanarSet& set) {
  Box box;
  for (const Segment& edge : edges(set)) {
    box.add(edge.source);
    box.add(edge.target);
  }
  for (const Point& p : set.isolated_vertices) box.add(p);
  return box;
}

}  // namespace

Rational extent(const Region& region) { return box_around(region).extent(); }
Rational extent(const PlanarSet& set) { return box_around(set).extent(); }

Region framed(Region region, const Rational& margin) {
  const auto missing =
      std::find_if(region.components.begin(), region.components.end(),
                   [](const Component& component) { return component.outer.empty(); });
  if (missing != region.components.end()) missing->outer = box_around(region).enlarged(margin);
  return region;
}

PlanarSet framed(PlanarSet set, const Rational& margin) {
  if (!set.is_unbounded) return set;
  set.outer.insert(set.outer.begin(), box_around(set).enlarged(margin));
  set.is_unbounded = false;
  return set;
}

PlanarSet unframed(PlanarSet set) {
  OPLUS_REQUIRES(!set.outer.empty(), "unframed");
  set.outer.erase(set.outer.begin());  // the one with the smallest vertex
  set.is_unbounded = true;
  return set;
}

}  // namespace oplus
