// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/point.hpp"

namespace oplus {

inline Vector direction_of(const Segment& s) { return s.target - s.source; }
inline Segment reversed(const Segment& s) { return {s.target, s.source}; }

/// Whether p lies on the closed segment s.
bool lies_on(const Point& p, const Segment& s);

/// Whether p lies on one of the closed segments.
bool lies_on_one(const Point& p, const std::vector<Segment>& segments);

/// Whether the interiors of a and b meet in one point and neither contains an end of the other.
bool cross_properly(const Segment& a, const Segment& b);

/// Whether a and b share more than one point.
bool overlap(const Segment& a, const Segment& b);

/// Returns the intersection of two closed segments: no point, one point, or the two ends of the
/// common part in lexicographic order.
std::vector<Point> intersection(const Segment& a, const Segment& b);

/// Returns s cut at those of the points that lie in its interior, in the order of its direction.
std::vector<Segment> cut(const Segment& s, std::vector<Point> points);

/// Returns the maximal segments whose union is that of the given ones: collinear segments that
/// share a point become one. Each is directed from its lexicographically smaller end; sorted.
std::vector<Segment> maximal_segments(std::vector<Segment> segments);

}  // namespace oplus
