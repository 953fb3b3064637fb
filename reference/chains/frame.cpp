// SPDX-License-Identifier: MIT
#include "reference/chains/frame.hpp"

#include <algorithm>
#include <optional>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/exact_box.hpp"

namespace oplus {

namespace {

/// Around the points of a set, if it has any.
std::optional<ExactBox> box_of(const std::vector<Segment>& edges,
                               const std::vector<Point>& points) {
  std::optional<ExactBox> box;
  if (!edges.empty()) box = box_around(edges);
  for (const Point& p : points) {
    if (!box) box = ExactBox(p);
    box->add(p);
  }
  return box;
}

Rational extent(const std::optional<ExactBox>& box) {
  if (!box) return 0;
  const Vector diagonal = box->high - box->low;
  return std::max(diagonal.x, diagonal.y);
}

Chain enlarged(const std::optional<ExactBox>& box, const Rational& margin) {
  OPLUS_REQUIRES(margin > 0, "framed");
  return box.value_or(ExactBox({0, 0})).enlarged(margin).corners();
}

}  // namespace

Rational extent(const Region& region) { return extent(box_of(edges(region), {})); }
Rational extent(const PlanarSet& set) { return extent(box_of(edges(set), set.isolated_vertices)); }

Region framed(Region region, const Rational& margin) {
  const auto missing =
      std::find_if(region.components.begin(), region.components.end(),
                   [](const Component& component) { return component.outer.empty(); });
  if (missing != region.components.end())
    missing->outer = enlarged(box_of(edges(region), {}), margin);
  return region;
}

PlanarSet framed(PlanarSet set, const Rational& margin) {
  if (!set.is_unbounded) return set;
  set.outer.insert(set.outer.begin(), enlarged(box_of(edges(set), set.isolated_vertices), margin));
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
