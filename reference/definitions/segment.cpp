// SPDX-License-Identifier: MIT
#include "reference/definitions/segment.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

bool apart(const Rational& a1, const Rational& a2, const Rational& b1, const Rational& b2) {
  return (a1 < b1 && a1 < b2 && a2 < b1 && a2 < b2) || (a1 > b1 && a1 > b2 && a2 > b1 && a2 > b2);
}

bool boxes_apart(const Segment& a, const Segment& b) {
  return apart(a.source.x, a.target.x, b.source.x, b.target.x) ||
         apart(a.source.y, a.target.y, b.source.y, b.target.y);
}

bool between(const Rational& low_or_high, const Rational& value, const Rational& high_or_low) {
  return (low_or_high <= value && value <= high_or_low) ||
         (high_or_low <= value && value <= low_or_high);
}

}  // namespace

bool lies_on(const Point& p, const Segment& s) {
  if (OPLUS_MUTANT("ends-are-not-on-their-segment",
                   "a segment is taken for one without its ends") &&
      (p == s.source || p == s.target))
    return false;
  return between(s.source.x, p.x, s.target.x) && between(s.source.y, p.y, s.target.y) &&
         orientation(s.source, s.target, p) == 0;
}

bool lies_on_one(const Point& p, const std::vector<Segment>& segments) {
  return std::any_of(segments.begin(), segments.end(),
                     [&](const Segment& s) { return lies_on(p, s); });
}

bool cross_properly(const Segment& a, const Segment& b) {
  if (boxes_apart(a, b)) return false;
  return orientation(a.source, a.target, b.source) * orientation(a.source, a.target, b.target) <
             0 &&
         orientation(b.source, b.target, a.source) * orientation(b.source, b.target, a.target) < 0;
}

bool overlap(const Segment& a, const Segment& b) { return intersection(a, b).size() == 2; }

std::vector<Point> intersection(const Segment& a, const Segment& b) {
  if (boxes_apart(a, b)) return {};
  std::vector<Point> common;
  for (const Point* end : {&a.source, &a.target})
    if (lies_on(*end, b)) common.push_back(*end);
  for (const Point* end : {&b.source, &b.target})
    if (lies_on(*end, a)) common.push_back(*end);
  std::sort(common.begin(), common.end());
  common.erase(std::unique(common.begin(), common.end()), common.end());
  if (common.empty() && cross_properly(a, b)) {
    const Vector u = direction_of(a);
    const Vector v = direction_of(b);
    const Rational t = cross(b.source - a.source, v) / cross(u, v);
    common.push_back(a.source + t * u);
  }
  OPLUS_ENSURES(common.size() <= 2, "two segments meet in a point or a segment");
  return common;
}

std::vector<Segment> cut(const Segment& s, std::vector<Point> points) {
  std::erase_if(points,
                [&](const Point& p) { return p == s.source || p == s.target || !lies_on(p, s); });
  points.push_back(s.source);
  points.push_back(s.target);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (s.target < s.source) std::reverse(points.begin(), points.end());
  std::vector<Segment> pieces;
  for (std::size_t i = 1; i < points.size(); ++i) pieces.push_back({points[i - 1], points[i]});
  return pieces;
}

std::vector<Segment> maximal_segments(std::vector<Segment> segments) {
  // By the line that each is on, by its slope and where it meets the y-axis, or, if vertical, the x-axis.
  std::map<std::tuple<bool, Rational, Rational>, std::vector<Segment>> lines;
  std::vector<Point> points;
  for (Segment& s : segments) {
    if (s.target < s.source) std::swap(s.source, s.target);
    const Vector along = direction_of(s);
    if (sign(along.x) != 0) {
      const Rational slope = along.y / along.x;
      const Rational height = s.source.y - slope * s.source.x;
      lines[{false, slope, height}].push_back(std::move(s));
    } else if (sign(along.y) != 0) {
      const Rational x = s.source.x;
      lines[{true, 0, x}].push_back(std::move(s));
    } else {
      points.push_back(std::move(s.source));
    }
  }
  std::vector<Segment> maximal;
  for (auto& [line, on_line] : lines) {
    std::sort(on_line.begin(), on_line.end());
    const std::size_t first = maximal.size();
    for (Segment& s : on_line) {
      const bool is_apart =
          maximal.size() == first || maximal.back().target < s.source ||
          (OPLUS_MUTANT("segments-end-to-end-stay-apart",
                        "collinear segments that share only an end are not joined") &&
           s.source == maximal.back().target);
      if (is_apart)
        maximal.push_back(std::move(s));
      else if (maximal.back().target < s.target)
        maximal.back().target = std::move(s.target);
    }
  }
  for (Point& p : points)
    if (!lies_on_one(p, maximal)) maximal.push_back({p, p});
  std::sort(maximal.begin(), maximal.end());
  return maximal;
}

}  // namespace oplus
