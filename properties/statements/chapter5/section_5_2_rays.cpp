// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/arrangement/ray_shooting.hpp"
#include "checked/arrangement/winding_numbers.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/ray.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Tests every edge of the arrangement of the full convolution, in both directions. That includes
/// horizontal and vertical edges, and rays through vertices and along overlaps.
Outcome check_ray_shooting(const Summands& summands) {
  Outcome outcome;
  const std::vector<ConvolutionSegment> full =
      full_convolution(convolution_cycles(summands.p, summands.q));
  const RayShooting rays(segments(full));
  const ConvolutionArrangement arrangement(full);
  const std::vector<int> of_faces = winding_numbers(arrangement);
  for (ConvolutionArrangement::Halfedge h = 0; h < 2 * arrangement.edge_count(); ++h) {
    const Segment edge = arrangement.geometry(h);
    const int by_ray = rays.winding_number_right_of(edge);
    const int by_faces = of_faces[arrangement.face(ConvolutionArrangement::twin(h))];
    ++outcome.counts[by_ray == 0 ? "faces outside the sum" : "faces inside the sum"];
    if (by_ray == by_faces) continue;
    return outcome.fail("right of " + to_string(edge.source) + " to " + to_string(edge.target) +
                            " the ray counts " + std::to_string(by_ray) + ", the faces " +
                            std::to_string(by_faces),
                        midpoint(edge.source, edge.target));
  }
  return outcome;
}

const Registered section_5_2(larger_mixture(),
                             {.id = "section-5.2",
                              .kills = {"overlapping-segments-count-once", "rays-shift-down",
                                        "rays-start-left-of-their-edge"},
                              .cases = 600,
                              .check = check_ray_shooting});

constexpr std::size_t most_pieces = 24;  // per pair

/// Signed crossings of the ray from x to the right with the segments that do not contain x, and
/// with those that do.
struct Crossings {
  int ahead = 0;
  int here = 0;
};

/// A segment's upper end is not part of it.
Crossings crossings(const Point& x, const std::vector<Segment>& all) {
  Crossings result;
  for (const Segment& s : all) {
    const bool upward = s.source.y <= x.y && x.y < s.target.y;
    const bool downward = s.target.y <= x.y && x.y < s.source.y;
    if (!upward && !downward) continue;
    const int side = orientation(s.source, s.target, x) * (upward ? 1 : -1);
    const int sign = upward ? 1 : -1;
    if (side > 0) result.ahead += sign;
    if (side == 0) result.here += sign;
  }
  return result;
}

/// The segments, cut where they meet: the middle of a piece is only on segments that run along it.
std::vector<Segment> pieces_of(const std::vector<Segment>& all) {
  std::vector<Segment> pieces;
  for (const std::vector<Segment>& of_segment : cut_at_intersections(all))
    pieces.insert(pieces.end(), of_segment.begin(), of_segment.end());
  return pieces;
}

/// A point directly to the right of the middle of a segment.
Point right_of(const Segment& edge, const std::vector<Segment>& all) {
  const Point middle = midpoint(edge.source, edge.target);
  const Vector along = direction_of(edge);
  return point_beside(middle, {along.y, -along.x}, all);
}

Outcome check_rays_from_an_edge(const Summands& summands) {
  Outcome outcome;
  const std::vector<Segment> all = segments(traced_convolution(summands.p, summands.q));
  const RayShooting rays(all);
  const Region reflected_q = reflected(summands.q);
  const std::vector<Segment> pieces = pieces_of(all);
  const std::size_t looked_at = std::min(pieces.size(), most_pieces);
  for (std::size_t k = 0; k < looked_at; ++k) {
    const Segment& edge = pieces[k * pieces.size() / looked_at];
    const Point middle = midpoint(edge.source, edge.target);
    const Point beside = right_of(edge, all);
    const int winding = winding_number(beside, all);
    const auto expect = [&](bool is_so, const std::string& what) {
      if (is_so || outcome.kind == Outcome::Kind::fails) return;
      outcome.fail("right of the middle of " + to_string(edge.source) + " to " +
                       to_string(edge.target) + " the winding number is " +
                       std::to_string(winding) + ", " + what,
                   beside);
    };
    expect(rays.winding_number_right_of(edge) == winding,
           "the ray counts " + std::to_string(rays.winding_number_right_of(edge)));
    const int rise = sign(edge.target.y - edge.source.y);
    if (rise != 0) {
      const Crossings seen = crossings(middle, all);
      // A ray from the right of an upward edge does not cross it; a ray from the right of a
      // downward edge crosses it and all segments that overlap it.
      const int expected = rise > 0 ? seen.ahead : seen.ahead + seen.here;
      ++outcome.counts[rise > 0 ? "upward edges" : "downward edges"];
      expect(expected == winding, "crossings make it " + std::to_string(expected));
    }
    const bool in_sum = interiors_meet(summands.p, translated(reflected_q, beside));
    ++outcome.counts[in_sum ? "faces in the sum" : "faces of the complement"];
    expect((winding > 0) == in_sum,
           std::string("and the interiors ") + (in_sum ? "meet" : "do not meet"));
  }
  return outcome;
}

const Registered observation_5_2_1(small_mixture(),
                                   {.id = "observation-5.2.1",
                                    .kills = {"rays-start-left-of-their-edge", "rays-shift-down"},
                                    .cases = 100,
                                    .check = check_rays_from_an_edge});

}  // namespace

}  // namespace oplus
