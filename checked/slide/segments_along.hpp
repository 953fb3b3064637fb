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
      : tracks_(tracks), scaling_(scaling), tree_(boxes(tracks)) {}

  /// Those that have more than a point in common with an edge, in either direction, sorted.
  std::vector<std::uint32_t> along(const Segment& edge) const {
    const NearPoint a = near(edge.source), b = near(edge.target);
    const double margin = tracks_.summands().margins.coordinate;
    const Box upper = NearPoint{std::max(a.x, b.x), std::max(a.y, b.y)}.box(margin);
    const Box lower = NearPoint{std::min(a.x, b.x), std::min(a.y, b.y)}.box(margin);
    std::vector<std::uint32_t> found;
    any_leaf_around(tree_, box_of(upper[0], upper[1], lower[2], lower[3]), [&](std::uint32_t i) {
      if (overlap(in_the_plane(tracks_[i], scaling_), edge)) found.push_back(i);
      return false;
    });
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  static std::vector<Box> boxes(const Tracks<Numbers>& tracks) {
    std::vector<Box> boxes;
    boxes.reserve(tracks.size());
    for (std::uint32_t i = 0; i < tracks.size(); ++i) boxes.push_back(box_around(tracks[i].near));
    return boxes;
  }

  /// A point of the plane as segments have them in doubles.
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
