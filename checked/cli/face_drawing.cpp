// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/face_drawing.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "reference/definitions/squared_distance.hpp"

namespace oplus {

namespace {

struct Range {
  Rational low;
  Rational high;

  Rational length() const { return high - low; }
};

template <typename Points, typename Coordinate>
Range range(const Points& points, Coordinate coordinate) {
  Range result{coordinate(points.front()), coordinate(points.front())};
  for (const auto& point : points) {
    result.low = std::min(result.low, coordinate(point));
    result.high = std::max(result.high, coordinate(point));
  }
  return result;
}

const Rational& x_of(const Point& p) { return p.x; }
const Rational& y_of(const Point& p) { return p.y; }
const Rational& x_of_source(const Segment& s) { return s.source.x; }

/// A height inside the range, at about the given part of it, that is no height of a vertex.
Rational height_between(const std::set<Rational>& heights, const Rational& part) {
  const Rational height = *heights.begin() + part * (*heights.rbegin() - *heights.begin());
  const auto above = heights.upper_bound(height);
  return *std::prev(above) == height ? Rational((height + *above) / 2) : height;
}

/// The pieces of a horizontal line inside the face that is to the left of all boundary segments.
/// Requires: none of them has an end on the line.
std::vector<Range> pieces_inside(const std::vector<Segment>& boundary, const Rational& y) {
  std::set<Rational> crossings;
  std::set<Rational> crossings_from_the_left;  // of segments that have the face at their right side
  for (const Segment& s : boundary) {
    if ((s.source.y < y) == (s.target.y < y)) continue;
    const Vector d = direction_of(s);
    const Rational x = s.source.x + d.x * (y - s.source.y) / d.y;
    crossings.insert(x);
    if (sign(d.y) < 0) crossings_from_the_left.insert(x);
  }
  std::vector<Range> pieces;
  for (const Rational& x : crossings_from_the_left)
    pieces.push_back({x, *crossings.upper_bound(x)});
  return pieces;
}

}  // namespace

FaceDrawing::FaceDrawing(const ConvolutionArrangement& arrangement) : arrangement_(arrangement) {
  points_.reserve(arrangement.vertex_count());
  for (ConvolutionArrangement::Vertex v = 0; v < arrangement.vertex_count(); ++v)
    points_.push_back(arrangement.point(v));
  if (points_.empty()) return;
  smallest_ = std::max(range(points_, x_of).length(), range(points_, y_of).length()) / 100;
}

std::vector<std::vector<Segment>> FaceDrawing::boundaries(Face face) const {
  std::vector<std::vector<Segment>> result;
  for (const Halfedge first : arrangement_.boundaries(face)) {
    std::vector<Segment>& boundary = result.emplace_back();
    Halfedge h = first;
    do {
      boundary.push_back({points_[arrangement_.source(h)], points_[arrangement_.target(h)]});
      h = arrangement_.next(h);
    } while (h != first);
  }
  return result;
}

Component FaceDrawing::outline(Face face) const {
  Component result;
  for (const std::vector<Segment>& boundary : boundaries(face)) {
    Chain chain;
    for (const Segment& s : boundary) chain.push_back(s.source);
    if (result.outer.empty())
      result.outer = std::move(chain);
    else
      result.holes.push_back(std::move(chain));
  }
  return result;
}

std::optional<FreeDisk> FaceDrawing::free_disk(Face face) const {
  std::vector<Segment> boundary;
  std::set<Rational> heights;
  for (const std::vector<Segment>& one : boundaries(face)) {
    boundary.insert(boundary.end(), one.begin(), one.end());
    for (const Segment& s : one) heights.insert(s.source.y);
  }
  if (*heights.rbegin() - *heights.begin() < smallest_ ||
      range(boundary, x_of_source).length() < smallest_)
    return std::nullopt;

  std::optional<FreeDisk> best;
  for (const int eighth : {4, 3, 5, 2, 6, 1, 7}) {  // of equal disks, that in the middle
    const Rational y = height_between(heights, Rational(eighth) / 8);
    for (const auto& [low, high] : pieces_inside(boundary, y)) {
      const Point centre{(low + high) / 2, y};
      Rational radius = squared_distance(centre, boundary.front());
      for (const Segment& s : boundary) radius = std::min(radius, squared_distance(centre, s));
      if (!best || radius > best->squared_radius) best = FreeDisk{centre, radius};
    }
  }
  return best;
}

}  // namespace oplus
