// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "properties/runner/registry.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/tangent_set.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

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

Outcome check(const Summands& summands) {
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

const Registered registered(small_mixture(), {.id = "lemma-2.2.9",
                                              .kills = {"reflex-turns-clockwise"},
                                              .cases = 100,
                                              .check = check});

}  // namespace

}  // namespace oplus
