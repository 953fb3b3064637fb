// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "checked/slide/boxes_around.hpp"
#include "checked/slide/exact_point.hpp"
#include "checked/slide/tracks.hpp"

namespace oplus::slide {

/// The segments of the reduced convolution, to find those that run along an edge.
template <typename Numbers>
class SegmentsAlong {
 public:
  SegmentsAlong(const Tracks<Numbers>& tracks, const Scaling& scaling)
      : tracks_(tracks), scaling_(scaling), tree_(boxes()) {}

  /// Those that have more than a point in common with an edge, in either direction, sorted.
  std::vector<std::uint32_t> along(const Segment& edge) const {
    const NearPoint a = near(edge.source), b = near(edge.target);
    const double error = 2 * tracks_.summands().margins.point;
    const Box upper = NearPoint{std::max(a.x, b.x), std::max(a.y, b.y), error}.box();
    const Box lower = NearPoint{std::min(a.x, b.x), std::min(a.y, b.y), error}.box();
    std::vector<std::uint32_t> found;
    any_leaf_around(tree_, box_of(upper[0], upper[1], lower[2], lower[3]), [&](std::uint32_t i) {
      if (overlap(in_the_plane(tracks_[i], scaling_), edge)) found.push_back(i);
      return false;
    });
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  std::vector<Box> boxes() const {
    std::vector<Box> boxes;
    boxes.reserve(tracks_.size());
    for (std::uint32_t i = 0; i < tracks_.size(); ++i) {
      const IntegerSegment<Numbers> segment = tracks_[i].exact;
      const ExactPoint<Numbers> a(segment, {0, 1}), b(segment, {1, 1});
      boxes.push_back(box_around(a.near_x(scaling_), a.near_y(scaling_), b.near_x(scaling_),
                                 b.near_y(scaling_)));
    }
    return boxes;
  }

  /// A point of the plane as exact points are in doubles.
  NearPoint near(const Point& point) const {
    const auto scaled = [&](const Rational& c, const mpz_class& of_p, const mpz_class& of_q) {
      Rational value = c * scaling_.denominator - of_p - of_q;
      mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), scaling_.shift);
      return value.get_d();
    };
    return {scaled(point.x, scaling_.of_p.x, scaling_.of_q.x),
            scaled(point.y, scaling_.of_p.y, scaling_.of_q.y)};
  }

  const Tracks<Numbers>& tracks_;
  const Scaling& scaling_;
  BoxTree tree_;
};

}  // namespace oplus::slide
