// SPDX-License-Identifier: MIT
#include "checked/distance/point_location.hpp"

#include <algorithm>
#include <utility>

#include "reference/chains/near_point.hpp"
#include "reference/chains/plane_sweep.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

namespace {

/// Its higher bits are as good as random (Knuth's multiplicative hashing).
std::uint32_t priority(std::uint32_t edge) { return (edge + 1) * 2654435769U; }

NearPoint near(const IntervalPoint& near, const Point& exact) { return {near, &exact}; }

/// Positive above an edge, negative below it.
template <typename Edge>
int side(const Edge& e, const NearPoint& x) {
  return orientation(near(e.near.source, e.exact.source), near(e.near.target, e.exact.target), x);
}

}  // namespace

PointLocation::PointLocation(const PlanarSet& open_set) : is_unbounded_(open_set.is_unbounded) {
  std::vector<Segment> segments = edges(open_set);
  edges_.reserve(segments.size());
  for (Segment& s : segments) {
    // The set is to the left; around dangling edges, which run right, on both sides.
    const bool runs_right = s.source < s.target;
    if (!runs_right) s = reversed(s);
    edges_.push_back({interval(s), std::move(s), runs_right});
  }
  SweptEdges swept;
  for (const Edge& e : edges_) swept.add(e.exact);
  for (const Point& p : open_set.isolated_vertices) swept.add(p);
  Index tree = none;
  sweep(swept, [&](const SweptPlace& place) {
    const NearPoint at = near_point(place.point);
    const auto is_through = [&](Index e) {
      return std::ranges::find(place.left, e) != place.left.end();
    };
    const auto [below, rest] =
        split(tree, [&](Index e) { return !is_through(e) && side(edges_[e], at) > 0; });
    const Index above = split(rest, is_through).second;
    tree = below;
    for (const Index e : place.right) tree = joined(tree, add({e, none, none}));
    tree = joined(tree, above);
    places_.push_back({at.near, place.point, tree});
    return true;
  });
}

PointLocation::Index PointLocation::add(const Node& node) {
  nodes_.push_back(node);
  return static_cast<Index>(nodes_.size() - 1);
}

/// Returns the tree of the edges that belong below, which come before all others, and that of the others.
template <typename Belongs>
std::pair<PointLocation::Index, PointLocation::Index> PointLocation::split(
    Index tree, const Belongs& belongs_below) {
  if (tree == none) return {none, none};
  Node node = nodes_[tree];
  if (belongs_below(node.edge)) {
    const auto [below, others] = split(node.higher, belongs_below);
    node.higher = below;
    return {add(node), others};
  }
  const auto [below, others] = split(node.lower, belongs_below);
  node.lower = others;
  return {below, add(node)};
}

PointLocation::Index PointLocation::joined(Index lower, Index higher) {
  if (lower == none || higher == none) return lower == none ? higher : lower;
  const bool is_lower_above = priority(nodes_[lower].edge) > priority(nodes_[higher].edge);
  Node root = nodes_[is_lower_above ? lower : higher];
  if (is_lower_above)
    root.higher = joined(root.higher, higher);
  else
    root.lower = joined(lower, root.lower);
  return add(root);
}

Location PointLocation::locate(const Point& x) const {
  const NearPoint at = near_point(x);
  const auto after = std::ranges::upper_bound(
      places_, at, [](const NearPoint& a, const NearPoint& b) { return compare(a, b) < 0; },
      [](const Place& place) { return near(place.near, place.exact); });
  bool is_inside = is_unbounded_;
  if (after != places_.begin()) {
    const Place& place = *std::prev(after);
    if (compare(near(place.near, place.exact), at) == 0) return Location::boundary;
    for (Index tree = place.above; tree != none;) {
      const Node& node = nodes_[tree];
      const Edge& edge = edges_[node.edge];
      const int found = side(edge, at);
      if (found == 0) return Location::boundary;
      if (found > 0) is_inside = edge.is_below_inside;
      tree = found > 0 ? node.higher : node.lower;
    }
  }
  return is_inside ? Location::inside : Location::outside;
}

}  // namespace oplus
