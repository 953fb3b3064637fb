// SPDX-License-Identifier: MIT
#include "checked/verify/grown_features.hpp"

#include <algorithm>
#include <utility>

#include "checked/verify/overlay.hpp"
#include "reference/definitions/point.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

/// The convex hull, counterclockwise. Requires: not all points are collinear.
Chain convex_hull(std::vector<Point> points) {
  points = sorted_without_copies(std::move(points));
  Chain hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= start + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

std::vector<Component> grown_features(const MinkowskiSum& set, const Rational& half) {
  std::vector<Component> result;
  const auto add_hull = [&](const std::vector<Point>& points) {
    std::vector<Point> corners;
    for (const Point& p : points)
      for (const Point& corner :
           {Point{-half, -half}, Point{half, -half}, Point{half, half}, Point{-half, half}})
        corners.push_back(p + corner);
    result.push_back({convex_hull(std::move(corners)), {}});
  };
  for (const Segment& s : set.dangling_edges) add_hull({s.source, s.target});
  for (const Point& p : set.isolated_vertices) add_hull({p});
  return result;
}

MinkowskiSum with_grown_features(const Region& region, const MinkowskiSum& set,
                                 const Rational& half) {
  GivenSum all{region, {}, {}};
  for (Component& component : grown_features(set, half))
    all.region.components.push_back(std::move(component));
  return canonical_sum(BoundaryFeatures{Overlay(all, {}).boundary_of_given(), {}, {}});
}

}  // namespace oplus
