// SPDX-License-Identifier: MIT
#include "checked/verify/sum_by_convex_parts.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "checked/collision/bounding_volume_hierarchy.hpp"
#include "checked/verify/convex_sums.hpp"
#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

std::vector<Point> ends_of(const std::vector<Segment>& segments) {
  std::vector<Point> ends;
  for (const Segment& s : segments) {
    ends.push_back(s.source);
    ends.push_back(s.target);
  }
  return sorted_without_copies(std::move(ends));
}

/// For each segment, the points inside it.
std::vector<std::vector<Point>> points_inside(const std::vector<Segment>& segments,
                                              const std::vector<Point>& points) {
  std::vector<Segment> as_segments;
  std::vector<IntervalPoint> near_points;
  for (const Point& p : points) {
    as_segments.push_back({p, p});
    near_points.push_back(interval(p));
  }
  std::vector<IntervalSegment> near;
  for (const Segment& s : segments) near.push_back(interval(s));
  std::vector<std::vector<Point>> result(segments.size());
  BoundingVolumeHierarchy(segments).visit_meeting(
      BoundingVolumeHierarchy(as_segments), {0, 0}, [&](std::size_t i, std::size_t j) {
        const std::optional<int> side =
            orientation(near[i].source, near[i].target, near_points[j]);
        const Segment& s = segments[i];
        if ((!side || *side == 0) && points[j] != s.source && points[j] != s.target &&
            lies_on(points[j], s))
          result[i].push_back(points[j]);
        return false;
      });
  return result;
}

/// The same segments, once each, cut where others end.
std::vector<Segment> cut_at_ends(std::vector<Segment> segments) {
  segments = sorted_without_copies(std::move(segments));
  std::vector<std::vector<Point>> inside = points_inside(segments, ends_of(segments));
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const std::vector<Segment> of_segment = cut(segments[i], std::move(inside[i]));
    pieces.insert(pieces.end(), of_segment.begin(), of_segment.end());
  }
  return sorted_without_copies(std::move(pieces));
}

/// Those of the points that are on none of the segments.
std::vector<Point> off_all(std::vector<Point> points, const std::vector<Segment>& segments) {
  points = sorted_without_copies(std::move(points));
  const std::vector<Point> ends = ends_of(segments);
  std::vector<Point> left;
  std::set_difference(points.begin(), points.end(), ends.begin(), ends.end(),
                      std::back_inserter(left));
  std::vector<Point> inside;
  for (const std::vector<Point>& of_segment : points_inside(segments, left))
    inside.insert(inside.end(), of_segment.begin(), of_segment.end());
  inside = sorted_without_copies(std::move(inside));
  points.clear();
  std::set_difference(left.begin(), left.end(), inside.begin(), inside.end(),
                      std::back_inserter(points));
  return points;
}

std::vector<std::size_t> starting_at(const std::vector<Segment>& edges,
                                     const std::vector<Point>& points) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (std::binary_search(points.begin(), points.end(), edges[i].source)) result.push_back(i);
  return result;
}

/// Where no segment of the reduced convolution may pass (docs/findings.md, Theorem 2.3.2).
void add_sums_of_touching_points(const Region& p, const Region& q, ConvexSums& sums,
                                 std::vector<Point>& outside) {
  const std::vector<Point> touching_p = touching_points(p);
  if (touching_p.empty()) return;
  const std::vector<std::size_t> of_p = starting_at(edges(p), touching_p);
  const std::vector<std::size_t> of_q = starting_at(edges(q), touching_points(q));
  for (const std::size_t e : of_p) {
    for (const std::size_t v : of_q) {
      const ConvexSums::Track track{Summand::P, e, v};
      if (sums.source_is_outside(track)) outside.push_back(sums.segment(track).source);
    }
  }
}

}  // namespace

MinkowskiSum sum_by_convex_parts(const Region& p, const Region& q, Boundary boundary) {
  ConvexSums sums(p, q);
  BoundaryFeatures features;
  for (const ConvexSums::Track& track : sums.reduced_convolution()) {
    if (boundary == Boundary::closed) {
      const std::vector<Segment> parts = sums.boundary_parts(track);
      features.edges.insert(features.edges.end(), parts.begin(), parts.end());
      continue;
    }
    ConvexSums::Outside outside = sums.outside_parts(track);
    features.edges.insert(features.edges.end(), outside.boundary.begin(), outside.boundary.end());
    for (Segment& s : outside.inside_closed_sum) {
      if (s.target < s.source) swap(s.source, s.target);
      features.dangling_edges.push_back(std::move(s));
    }
    features.isolated_vertices.insert(features.isolated_vertices.end(), outside.points.begin(),
                                      outside.points.end());
  }
  if (boundary == Boundary::open)
    add_sums_of_touching_points(p, q, sums, features.isolated_vertices);

  features.edges = cut_at_ends(std::move(features.edges));
  features.dangling_edges = sorted_without_copies(std::move(features.dangling_edges));
  std::vector<Segment> all = features.edges;
  all.insert(all.end(), features.dangling_edges.begin(), features.dangling_edges.end());
  features.isolated_vertices = off_all(std::move(features.isolated_vertices), all);
  return canonical_sum(features);
}

}  // namespace oplus
