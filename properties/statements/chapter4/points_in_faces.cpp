// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/points_in_faces.hpp"

#include <algorithm>
#include <set>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/direction.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/ray.hpp"

namespace oplus {

namespace {

/// Both directions of every piece of the segments between intersections, by source and angle.
class Halfedges {
 public:
  explicit Halfedges(const std::vector<Segment>& segments) {
    std::set<Segment> both;
    for (const std::vector<Segment>& of_segment : cut_at_intersections(segments)) {
      for (const Segment& piece : of_segment) both.insert({piece, reversed(piece)});
    }
    all_.assign(both.begin(), both.end());
    std::sort(all_.begin(), all_.end(), precedes);
  }

  /// One halfedge of each cycle; a cycle has one face to its left.
  std::vector<Segment> one_of_each_cycle() const {
    std::vector<bool> seen(all_.size(), false);
    std::vector<Segment> result;
    for (std::size_t start = 0; start < all_.size(); ++start) {
      if (seen[start]) continue;
      result.push_back(all_[start]);
      for (std::size_t e = start; !seen[e]; e = following(e)) seen[e] = true;
    }
    return result;
  }

 private:
  static bool precedes(const Segment& a, const Segment& b) {
    if (a.source != b.source) return a.source < b.source;
    return compare_angle(direction_of(a), direction_of(b)) < 0;
  }

  /// The next one clockwise from the reversed halfedge, so the leftmost.
  std::size_t following(std::size_t e) const {
    const Segment back = reversed(all_[e]);
    const auto at = std::lower_bound(all_.begin(), all_.end(), back, precedes);
    if (at != all_.begin() && std::prev(at)->source == back.source)
      return static_cast<std::size_t>(at - all_.begin()) - 1;
    const auto end =
        std::find_if(at, all_.end(), [&](const Segment& s) { return s.source != back.source; });
    return static_cast<std::size_t>(end - all_.begin()) - 1;
  }

  std::vector<Segment> all_;
};

/// A vector along which no segment runs.
Vector across(const std::vector<Segment>& segments) {
  Vector v{1, 0};
  while (std::any_of(segments.begin(), segments.end(),
                     [&](const Segment& s) { return sign(cross(v, direction_of(s))) == 0; }))
    v.y += 1;
  return v;
}

}  // namespace

std::vector<Point> points_in_faces(const std::vector<Segment>& segments,
                                   const std::vector<Segment>& avoided) {
  std::vector<Segment> all = segments;
  all.insert(all.end(), avoided.begin(), avoided.end());
  const Vector v = across(all);
  std::vector<Point> points;
  for (const Segment& e : Halfedges(segments).one_of_each_cycle()) {
    const bool leads_left = sign(cross(direction_of(e), v)) > 0;
    points.push_back(point_beside(midpoint(e.source, e.target), leads_left ? v : -v, all));
  }
  return points;
}

std::vector<Point> generic_placements(const Summands& summands) {
  const auto& [p, q] = summands;
  std::vector<Segment> both = segments(convolution(p, q));
  for (const Segment& s : segments(original_convolution(p, q))) both.push_back(s);
  return points_in_faces(both, segments(vertex_edge_sum(p, q)));
}

}  // namespace oplus
