// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ranges>
#include <set>

#include "properties/runner/registry.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/tangent_set.hpp"
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
Outcome check_edge_point_neighborhood(const Summands& summands) {
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

const Registered observation_2_2_4({
    .id = "observation-2.2.4",
    .sources = {{"grid", 5, 6}, {"tight", 1, 1}, {"holes", 4, 3}, {"components", 4, 2}},
    .promises =
        {{"holes", 15}, {"several components", 5}, {"reflex vertices", 10}, {"parallel edges", 40}},
    .kills = {"containment-is-no-collision"},
    .cases = 60,
    .check = check_edge_point_neighborhood,
});

/// Whether x is the sum of a point inside a piece of an edge of P and one of Q, in equal directions
/// and in different ones. The edges of -Q + x are those of Q reversed.
struct SumsOfInsidePoints {
  bool equal = false;
  bool different = false;
};

SumsOfInsidePoints sums_of_inside_points(const Region& p, const Region& placed) {
  SumsOfInsidePoints found;
  const std::vector<Segment> of_q = boundary_pieces(placed);
  for (const Segment& s : boundary_pieces(p)) {
    for (const Segment& t : of_q) {
      if (cross_properly(s, t)) found.different = true;
      if (!overlap(s, t)) continue;
      const bool is_same = sign(dot(direction_of(s), direction_of(t))) > 0;
      (is_same ? found.different : found.equal) = true;
    }
  }
  return found;
}

/// Sums of middles and quarters of pieces: on a grid, many of them are placements where more than
/// these two pieces meet.
std::set<Point> sums_of_some_inside_points(const Summands& summands) {
  std::set<Point> sums;
  const std::vector<Segment> of_q = boundary_pieces(summands.q);
  for (const Segment& s : boundary_pieces(summands.p)) {
    const Point middle = midpoint(s.source, s.target);
    for (const Segment& t : of_q) {
      const Point middle_of_t = midpoint(t.source, t.target);
      sums.insert({middle + middle_of_t, midpoint(s.source, middle) + middle_of_t});
    }
  }
  return sums;
}

constexpr std::size_t most_sums = 20;  // per pair

Outcome check_points_inside_edges(const Summands& summands) {
  Outcome outcome;
  const Region reflected_q = reflected(summands.q);
  const std::set<Point> sums_of_points = sums_of_some_inside_points(summands);
  const std::vector<Point> all(sums_of_points.begin(), sums_of_points.end());
  const std::size_t looked_at = std::min(all.size(), most_sums);
  for (std::size_t k = 0; k < looked_at; ++k) {
    const Point& x = all[k * all.size() / looked_at];
    const Region placed = translated(reflected_q, x);
    const SumsOfInsidePoints sums = sums_of_inside_points(summands.p, placed);
    ++outcome.counts["sums of points inside edges"];
    const bool is_in_sum = std::ranges::any_of(
        overlaid({summands.p, placed}),
        [](const OverlaidPoint& a) { return a.is_in(0, true) && a.is_in(1, true); });
    if (!is_in_sum) ++outcome.counts["of them, not in the open sum"];
    if (sums.different && !is_in_sum) {
      outcome.fail(to_string(x) +
                       " is a sum of points inside edges of different directions, but "
                       "not in the open sum",
                   x);
    } else if (interiors_meet(summands.p, placed) != is_in_sum) {
      outcome.fail("at " + to_string(x) + " the collision test says that the interiors " +
                       (is_in_sum ? "do not meet, and they do" : "meet, and they do not"),
                   x);
    }
    if (outcome.kind == Outcome::Kind::fails) break;
  }
  return outcome;
}

const Registered lemma_2_2_5({
    .id = "lemma-2.2.5",
    .sources = {{"grid", 5, 4}, {"tight", 1, 1}, {"holes", 3, 5}, {"components", 3, 2}},
    .promises =
        {{"holes", 15}, {"several components", 5}, {"reflex vertices", 10}, {"parallel edges", 40}},
    .kills = {"edges-are-not-cut-where-chains-touch", "parallel-edges-do-not-collide"},
    .cases = 80,
    .check = check_points_inside_edges,
});

/// Whether an edge at the vertex, seen from it, points to the right of d.
bool slides(const Vector& d, const Corner& corner) {
  return sign(cross(d, corner.out)) < 0 || sign(cross(d, -corner.in)) < 0;
}

bool is_parallel(const Vector& d, const Corner& corner) {
  return sign(cross(d, corner.in)) == 0 || sign(cross(d, corner.out)) == 0;
}

/// The points where another chain touches the edge of a segment, translated by the segment's
/// vertex.
std::set<Point> touched_points(const std::vector<Point>& touching, const Point& vertex) {
  std::set<Point> points;
  for (const Point& p : touching) points.insert(p + vertex);
  return points;
}

Outcome check_sliding(const Summands& summands) {
  Outcome outcome;
  const auto fail = [&](const std::string& why, const Point& at) {
    if (outcome.kind == Outcome::Kind::holds) outcome.fail(why, at);
  };
  OpenSum open_sum(summands);
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  const std::vector<Point> touching_p = touching_points(summands.p);
  const std::vector<Point> touching_q = touching_points(summands.q);
  std::set<Origin> kept;
  for (const ConvolutionSegment& s : convolution(summands.p, summands.q)) kept.insert(s.origin);
  const std::vector<ConvolutionSegment> all = vertex_edge_sum(summands.p, summands.q);
  const std::vector<std::vector<Segment>> pieces = cut_at_intersections(segments(all));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_edge_of_p = all[i].origin.edge_of == Summand::P;
    const VertexIndex& index = all[i].origin.vertex;
    const std::vector<Chain>& with_vertex = is_edge_of_p ? of_q : of_p;
    const Corner corner = corner_at(with_vertex[index.chain], index.vertex);
    const Vector d = direction_of(all[i].segment);
    const bool is_slid = slides(d, corner);
    if (!is_parallel(d, corner)) {
      const bool is_kept = kept.count(all[i].origin) > 0;
      const auto& [source, target] = all[i].segment;
      const std::string name = "the segment from " + to_string(source) + " to " + to_string(target);
      const Point middle = midpoint(source, target);
      if (!is_kept && !is_slid)
        fail(name + " does not slide, and is not in the convolution", middle);
      if (is_kept && is_slid && sign(cross(corner.in, corner.out)) > 0)
        fail(name + " slides at a convex vertex, and is in the convolution", middle);
    }
    if (!is_slid) continue;
    ++outcome.counts["segments that slide"];
    const std::set<Point> left_out = touched_points(is_edge_of_p ? touching_p : touching_q,
                                                    with_vertex[index.chain][index.vertex]);
    const auto look_at = [&](const Point& x) {
      if (left_out.count(x) > 0)
        ++outcome.counts["points where a chain touches the edge, left out"];
      else if (!open_sum.contains(x))
        fail("the segment from " + to_string(all[i].segment.source) + " to " +
                 to_string(all[i].segment.target) + " slides, but its point " + to_string(x) +
                 " is not in the open sum",
             x);
    };
    for (const Segment& piece : pieces[i]) {
      look_at(midpoint(piece.source, piece.target));
      if (piece.target != all[i].segment.target) look_at(piece.target);
    }
  }
  return outcome;
}

const Registered lemma_2_2_9(small_mixture(), {.id = "lemma-2.2.9",
                                               .kills = {"reflex-turns-clockwise"},
                                               .cases = 100,
                                               .check = check_sliding});

}  // namespace

}  // namespace oplus
