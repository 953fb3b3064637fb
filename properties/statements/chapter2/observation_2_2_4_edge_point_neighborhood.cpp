// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "properties/runner/registry.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// A point on the ray from x before it meets a segment.
Point before_first_hit(const Point& x, const Vector& along, const std::vector<Segment>& segments) {
  const Segment first = cut_where_met({x, x + along}, segments).front();
  return midpoint(first.source, first.target);
}

/// Returns a point near x in every edge and every face of the segments' arrangement that touches x
/// and lies strictly to the left of the line through x along the given direction. What is constant
/// in edges and faces holds in a small half disk iff it holds at these points. Requires: along is
/// not zero.
std::vector<Point> points_to_the_left(const Point& x, const Vector& along,
                                      const std::vector<Segment>& segments) {
  std::vector<Vector> rays{along, -along};
  for (const Segment& s : segments) {
    if (!lies_on(x, s)) continue;
    for (const Vector& ray : {s.source - x, s.target - x})
      if (sign(cross(along, ray)) > 0) rays.push_back(ray);
  }
  const auto turns_left = [](const Vector& u, const Vector& v) { return sign(cross(u, v)) > 0; };
  const auto is_same = [](const Vector& u, const Vector& v) { return sign(cross(u, v)) == 0; };
  // From along to -along, which are the ends of this order but parallel.
  std::sort(rays.begin() + 2, rays.end(), turns_left);
  rays.erase(std::unique(rays.begin() + 2, rays.end(), is_same), rays.end());
  std::rotate(rays.begin() + 1, rays.begin() + 2, rays.end());

  std::vector<Point> points;
  for (std::size_t i = 1; i < rays.size(); ++i) {
    const bool is_half_plane = rays.size() == 2;
    const Vector between = is_half_plane ? Vector{-along.y, along.x} : rays[i - 1] + rays[i];
    points.push_back(before_first_hit(x, between, segments));
    if (i + 1 < rays.size()) points.push_back(before_first_hit(x, rays[i], segments));
  }
  return points;
}

constexpr std::size_t most_half_disks = 60;  // per pair

struct HalfDisk {
  Point centre;
  Vector along;
};

/// The middle of an edge, at a vertex and at the middle of an edge of the other summand.
void add_half_disks(const Region& with_edges, const Region& other_region,
                    std::vector<HalfDisk>& all) {
  for (const Segment& piece : boundary_pieces(with_edges)) {
    const Vector along = direction_of(piece);
    const Point middle = midpoint(piece.source, piece.target);
    for (const Segment& of_other : boundary_pieces(other_region)) {
      all.push_back({middle + of_other.source, along});
      all.push_back({middle + midpoint(of_other.source, of_other.target), along});
    }
  }
}

/// Tests points of half disks, one in each cell of the vertex-edge sum's arrangement. Whether a
/// point is in the open sum is constant in a cell: it changes only where a vertex of P or -Q+x
/// meets an edge of the other.
Outcome check(const Summands& summands) {
  std::vector<HalfDisk> all;
  add_half_disks(summands.p, summands.q, all);
  add_half_disks(summands.q, summands.p, all);
  const std::vector<Segment> sums = segments(vertex_edge_sum(summands.p, summands.q));
  OpenSum open_sum(summands);
  Outcome outcome;
  const std::size_t looked_at = std::min(all.size(), most_half_disks);
  for (std::size_t k = 0; k < looked_at; ++k) {
    const auto& [centre, along] = all[k * all.size() / looked_at];
    ++outcome.counts["half disks"];
    for (const Point& y : points_to_the_left(centre, along, sums)) {
      if (outcome.kind == Outcome::Kind::fails || open_sum.contains(y)) continue;
      outcome.fail("the half disk around " + to_string(centre) + " contains " + to_string(y) +
                       ", which is not in the open sum",
                   y);
    }
  }
  return outcome;
}

const Registered registered({
    .id = "observation-2.2.4",
    .sources = {{"grid", 5, 6}, {"tight", 1, 1}, {"holes", 4, 3}, {"components", 4, 2}},
    .promises =
        {{"holes", 15}, {"several components", 5}, {"reflex vertices", 10}, {"parallel edges", 40}},
    .kills = {"containment-is-no-collision"},
    .cases = 60,
    .check = check,
});

}  // namespace

}  // namespace oplus
