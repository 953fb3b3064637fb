// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "checked/slide/named_ends.hpp"
#include "checked/slide/open_places.hpp"
#include "checked/slide/open_sum_test.hpp"
#include "checked/slide/parallel_for.hpp"
#include "checked/slide/pieces_on_lines.hpp"

namespace oplus::slide {

/// What the open sum has in addition to the closed one.
struct LowDimensionalFeatures {
  std::vector<Segment> dangling_edges;
  std::vector<Point> isolated_vertices;
};

/// Segments from one point to another, for the question whether a point is on one of them.
template <typename Numbers>
class PointLocation {
 public:
  using Ends = std::pair<const ExactPoint<Numbers>*, const ExactPoint<Numbers>*>;

  PointLocation(std::vector<Ends> segments, const Scaling& scaling)
      : segments_(std::move(segments)), scaling_(scaling), tree_(boxes()) {}

  bool is_on_one(const ExactPoint<Numbers>& x) const {
    const ApproximatePoint near{x.near_x(scaling_), x.near_y(scaling_),
                                2 * margins(scaling_).point};
    return any_leaf_around(tree_, near.box(), [&](std::uint32_t i) {
      const auto& [a, b] = segments_[i];
      return x == *a || x == *b || lies_between(x, *a, *b, scaling_);
    });
  }

 private:
  std::vector<FloatBox> boxes() const {
    std::vector<FloatBox> boxes;
    boxes.reserve(segments_.size());
    for (const auto& [a, b] : segments_)
      boxes.push_back(box_around(a->near_x(scaling_), a->near_y(scaling_), b->near_x(scaling_),
                                 b->near_y(scaling_)));
    return boxes;
  }

  std::vector<Ends> segments_;
  const Scaling& scaling_;
  FloatBoxTree tree_;
};

/// A place on a line, as a point, too.
template <typename Numbers>
struct PointOnSegment {
  PointOnSegment(const ReducedSegment<Numbers>& of, const Fraction<Numbers>& at,
                 const Scaling& scaling)
      : segment(of),
        t(at),
        point(of.exact, at),
        near{point.near_x(scaling), point.near_y(scaling)} {}

  ReducedSegment<Numbers> segment;
  Fraction<Numbers> t;
  ExactPoint<Numbers> point;
  ApproximatePoint near;
};

/// The sums of points in which chains of P touch and points in which chains of Q touch.
template <typename Numbers>
void add_sums_of_touching_points(const IntegerSummands<Numbers>& summands,
                                 const RaysOfBoth<Numbers>& rays, const Scaling& scaling,
                                 std::vector<PointOnSegment<Numbers>>& points) {
  if (OPLUS_MUTANT("touching-points-are-not-tested")) return;
  const std::vector<std::uint32_t> of_q = rays[1].touching_points();
  for (const std::uint32_t v : rays[0].touching_points()) {
    for (const std::uint32_t w : of_q) {
      const NearSegment& near_v = summands.p.near[v];
      const NearSegment& near_w = summands.q.near[w];
      // On a line in some direction.
      points.push_back({{{summands.p.edges[v].source + summands.q.edges[w].source, {1, 0}},
                         {near_v.x + near_w.x, near_v.y + near_w.y, 0, 0},
                         error_of_places(near_v, near_w),
                         {EdgePair{v, w}, EdgePair{v, w}}},
                        {0, 1},
                        scaling});
    }
  }
}

/// Of equal points one, in the order in which they are first.
template <typename Numbers>
void remove_copies(std::vector<PointOnSegment<Numbers>>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  // Equal points are equal in doubles, too.
  const auto is_before = [&](std::uint32_t i, std::uint32_t j) {
    const auto& a = points[i];
    const auto& b = points[j];
    if (a.near.x != b.near.x) return a.near.x < b.near.x;
    if (a.near.y != b.near.y) return a.near.y < b.near.y;
    return a.point < b.point;
  };
  std::stable_sort(order.begin(), order.end(), is_before);
  order.erase(std::unique(order.begin(), order.end(),
                          [&](std::uint32_t i, std::uint32_t j) {
                            return points[i].point == points[j].point;
                          }),
              order.end());
  std::sort(order.begin(), order.end());
  std::vector<PointOnSegment<Numbers>> kept;
  kept.reserve(order.size());
  for (const std::uint32_t i : order) kept.push_back(std::move(points[i]));
  points = std::move(kept);
}

/// What no pair of edges blocks of the places that were found. Each place on a line is looked at once or
/// twice, on segments to the right.
template <typename Numbers>
OpenCandidates<Numbers> low_dimensional_candidates(const ReducedSegments<Numbers>& segments,
                                                   const RaysOfBoth<Numbers>& rays,
                                                   OpenCandidates<Numbers> found,
                                                   unsigned threads) {
  const auto is_right = [&](const FreePiece<Numbers>& piece) {
    return is_to_the_right(segments.direction(piece.segment));
  };
  const auto left = std::stable_partition(found.pieces.begin(), found.pieces.end(), is_right);
  const std::vector<FreePiece<Numbers>> others(left, found.pieces.end());
  found.pieces.erase(left, found.pieces.end());
  std::vector<FreePiece<Numbers>> pieces =
      PiecesOnLines<Numbers>(segments, found.pieces, segments.summands().margins).cover();
  pieces.insert(pieces.end(), others.begin(), others.end());
  found.pieces.clear();
  const auto find_in = [&](std::size_t first, std::size_t last) {
    OpenPlaces<Numbers> open(segments.summands(), rays);
    for (std::size_t i = first; i < last; ++i)
      open.look_into(pieces[i].segment, segments[pieces[i].segment], pieces[i].piece);
    return std::move(open.found);
  };
  for (OpenCandidates<Numbers>& of_lot : found_in_parts(pieces.size(), threads, find_in, in_a_lot))
    found.take(std::move(of_lot));
  // Of dangling edges the others show nothing new.
  std::erase_if(found.pieces, [&](const auto& piece) { return !is_right(piece); });
  return found;
}

/// Decides which of the candidates, and of the sums of points in which chains touch (docs/findings.md,
/// on Theorem 2.3.2), are not in the open sum. `boundary` is that of the closed sum; points
/// on what is left out of it count as isolated.
template <typename Numbers>
LowDimensionalFeatures low_dimensional_features(const ReducedSegments<Numbers>& segments,
                                                const RaysOfBoth<Numbers>& rays,
                                                const OpenCandidates<Numbers>& candidates,
                                                const NamedEnds<Numbers>& boundary,
                                                const Scaling& scaling, unsigned threads) {
  const IntegerSummands<Numbers>& summands = segments.summands();
  const std::vector<FreePiece<Numbers>>& pieces = candidates.pieces;
  std::vector<PointOnSegment<Numbers>> points;
  for (const FreePiece<Numbers>& point : candidates.points)
    points.emplace_back(segments[point.segment], point.piece.from, scaling);
  add_sums_of_touching_points(summands, rays, scaling, points);
  if (pieces.empty() && points.empty()) return {};
  remove_copies(points);

  std::vector<typename PointLocation<Numbers>::Ends> of_boundary;
  of_boundary.reserve(boundary.pieces.size());
  for (const BoundaryPiece& piece : boundary.pieces)
    of_boundary.emplace_back(&boundary.points[piece.from], &boundary.points[piece.to]);
  std::optional<PointLocation<Numbers>> on_boundary;
  if (!of_boundary.empty()) on_boundary.emplace(std::move(of_boundary), scaling);
  std::vector<char> is_outside(pieces.size() + points.size());
  const auto decide = [&](std::size_t first, std::size_t last) {
    OpenSumTest<Numbers> open_sum(summands, rays);
    for (std::size_t i = first; i < last; ++i) {
      if (i < pieces.size()) {
        const auto& [segment, piece] = pieces[i];
        is_outside[i] = !open_sum.contains_by_components(segments[segment], place_inside(piece));
      } else {
        const auto& [segment, t, point, near] = points[i - pieces.size()];
        is_outside[i] =
            !(on_boundary && on_boundary->is_on_one(point)) && !open_sum.contains(segment, t);
      }
    }
  };
  for_each_part(is_outside.size(), threads, decide, in_a_lot);

  std::vector<FreePiece<Numbers>> dangling;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (is_outside[i]) dangling.push_back(pieces[i]);
  std::vector<ExactPoint<Numbers>> ends;
  PiecesOnLines<Numbers>(segments, dangling, summands.margins)
      .each_connected([&](const FreePiece<Numbers>& first, const FreePiece<Numbers>& last) {
        ends.emplace_back(segments[first.segment].exact, first.piece.from);
        ends.emplace_back(segments[last.segment].exact, last.piece.to);
      });
  LowDimensionalFeatures found;
  std::vector<typename PointLocation<Numbers>::Ends> of_dangling;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    of_dangling.emplace_back(&ends[i], &ends[i + 1]);
    found.dangling_edges.push_back(
        {ends[i].in_the_plane(scaling), ends[i + 1].in_the_plane(scaling)});
  }
  std::sort(found.dangling_edges.begin(), found.dangling_edges.end());
  std::optional<PointLocation<Numbers>> on_dangling;
  if (!of_dangling.empty()) on_dangling.emplace(std::move(of_dangling), scaling);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ExactPoint<Numbers>& x = points[i].point;
    if (is_outside[pieces.size() + i] && !(on_dangling && on_dangling->is_on_one(x)))
      found.isolated_vertices.push_back(x.in_the_plane(scaling));
  }
  std::sort(found.isolated_vertices.begin(), found.isolated_vertices.end());
  return found;
}

}  // namespace oplus::slide
