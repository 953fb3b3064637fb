// SPDX-License-Identifier: MIT
#include "checked/certificates/seams.hpp"

#include <algorithm>

#include "reference/arithmetic/simplest_between.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus::certificates {

namespace {

Rational coordinate(const CellCorner& corner, const IntegerLine& line) {
  const Point point = point_of(corner.exact);
  return abs(line.a) <= abs(line.b) ? point.x : point.y;
}

/// A short number between two others, by far.
Rational short_between(const Rational& a, const Rational& b) {
  const Rational quarter = (b - a) / 4;
  Rational low = a + quarter, high = b - quarter;
  if (low > high) swap(low, high);
  if (sgn(low) >= 0) return simplest_between(low, high);
  if (sgn(high) <= 0) return -simplest_between(-high, -low);
  return 0;
}

std::vector<Segment> features(const ClaimedSum& open_set) {
  std::vector<Segment> all = open_set.dangling_edges;
  for (const Point& p : open_set.isolated_vertices) all.push_back({p, p});
  return all;
}

}  // namespace

Seams::Seams(PieceSums& sums, const ShiftedDoubles& doubles, const ClaimedSum& open_set)
    : sums_(sums),
      doubles_(doubles),
      features_(features(open_set)),
      edges_(static_cast<std::uint32_t>(open_set.dangling_edges.size())) {}

Seam Seams::seam(const Corner& from, const Corner& to, const IntegerLine& line, const Pair& usual) {
  if (is_inside_between(usual, *from, *to)) return {};
  const Place middle{(from->near.x + to->near.x) / 2, (from->near.y + to->near.y) / 2};
  for (const Pair& pair : sums_.pairs_around(middle))
    if (is_inside_between(pair, *from, *to)) return {{pair}, {}};

  Seam seam;
  Corner start = from;
  std::optional<Stretch> stretch = longest(from, to, line, false);
  for (;;) {
    if (!stretch) stretch = along_edge(start, to, line);
    const auto [interval, end] = *stretch;
    seam.intervals.push_back(interval);
    if (end == to) return seam;
    stretch = longest(end, to, line, true);
    if (stretch) {
      // The two intervals overlap, so the point between them can be one whose coordinate is short.
      const Pair& pair = std::get<Pair>(stretch->interval);
      const Corner first = last_inside(pair, end, start, line);
      const Rational low = coordinate(*first, line), high = coordinate(*end, line);
      seam.points.push_back(
          {OPLUS_MUTANT(
               "seams-change-sums-too-early",
               "a seam of an open sum goes on in a sum of two pieces from where it enters that")
               ? low
               : short_between(low, high),
           pair});
    } else {
      seam.points.push_back({coordinate(*end, line), feature_at(end)});
      stretch = longest(end, to, line, false);
    }
    start = end;
  }
}

/// Whether both are in the sum of the pair, and all between them strictly.
bool Seams::is_inside_between(const Pair& pair, const CellCorner& from, const CellCorner& to) {
  sums_.sides(pair, half_planes_);
  for (const HalfPlane& side : half_planes_)
    if (std::min(side.above(from.near), side.above(to.near)) < -sums_.error()) return false;
  for (std::size_t side = 0; side < half_planes_.size(); ++side) {
    const int at_from = sums_.side_of(pair, side, half_planes_[side], from);
    const int at_to = sums_.side_of(pair, side, half_planes_[side], to);
    if (at_from < 0 || at_to < 0) return false;
    if (at_from == 0 && at_to == 0 &&
        !OPLUS_MUTANT(
            "seams-run-along-sides",
            "a seam of an open sum may be on the boundary of what it should be inside of"))
      return false;
  }
  return true;
}

bool Seams::is_inside(const Pair& pair, const CellCorner& corner) {
  sums_.sides(pair, half_planes_);
  for (std::size_t side = 0; side < half_planes_.size(); ++side)
    if (sums_.side_of(pair, side, half_planes_[side], corner) <= 0) return false;
  return true;
}

/// The last point on the way from one point to another for which is_inside_between holds; null where there is none.
Seams::Corner Seams::last_inside(const Pair& pair, const Corner& from, const Corner& to,
                                 const IntegerLine& line) {
  sums_.sides(pair, half_planes_);
  Corner end = to;
  for (std::size_t side = 0; side < half_planes_.size(); ++side) {
    const int at_from = sums_.side_of(pair, side, half_planes_[side], *from);
    const int at_end = sums_.side_of(pair, side, half_planes_[side], *end);
    if (at_from < 0 || (at_from == 0 && at_end <= 0)) return nullptr;
    if (at_end < 0)
      end = std::make_shared<const CellCorner>(meet(line, sums_.exact_side(pair, side)), doubles_);
  }
  return end;
}

/// The interval in the sum of a pair that reaches farthest from a point, in doubles; perhaps of those whose sum has the
/// point strictly inside.
std::optional<Seams::Stretch> Seams::longest(const Corner& from, const Corner& to,
                                             const IntegerLine& line, bool starts_inside) {
  std::optional<Stretch> best;
  double least_left = 0;
  for (const Pair& pair : sums_.pairs_around(from->near)) {
    if (starts_inside && !is_inside(pair, *from)) continue;
    Corner end = last_inside(pair, from, to, line);
    if (!end) continue;
    if (end == to) return Stretch{pair, to};
    const double left = std::hypot(to->near.x - end->near.x, to->near.y - end->near.y);
    if (best && left >= least_left) continue;
    least_left = left;
    best = {pair, std::move(end)};
  }
  return best;
}

/// The interval on a dangling edge from a point.
Seams::Stretch Seams::along_edge(const Corner& from, const Corner& to,
                                 const IntegerLine& line) const {
  for (const std::uint32_t i : features_around(point_of(from->exact))) {
    HomogeneousPoint first = homogeneous(features_[i].source);
    HomogeneousPoint last = homogeneous(features_[i].target);
    if (side_of(line, first) != 0 || side_of(line, last) != 0) continue;
    if (order_along(line, first, last) > 0) std::swap(first, last);
    if (order_along(line, first, from->exact) > 0 || order_along(line, last, from->exact) <= 0)
      continue;
    if (order_along(line, last, to->exact) >= 0) return {DanglingEdge{i}, to};
    return {DanglingEdge{i}, std::make_shared<const CellCorner>(std::move(last), doubles_)};
  }
  throw PointOutsideSum(point_of(from->exact));
}

/// The vertex or edge at a point.
Seam::Place Seams::feature_at(const Corner& corner) const {
  const Point point = point_of(corner->exact);
  for (const std::uint32_t i : features_around(point)) {
    if (!lies_on(point, features_[i])) continue;
    if (i >= edges_) return IsolatedVertex{i - edges_};
    return DanglingEdge{i};
  }
  throw PointOutsideSum(point);
}

/// Those whose boxes are around a point, or nearly, in their order.
std::vector<std::uint32_t> Seams::features_around(const Point& point) const {
  std::vector<std::uint32_t> found;
  features_.look_at_meeting(box_of(interval(Segment{point, point})),
                            [&](std::size_t i) { found.push_back(static_cast<std::uint32_t>(i)); });
  std::ranges::sort(found);
  return found;
}

}  // namespace oplus::certificates
