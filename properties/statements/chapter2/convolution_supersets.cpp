// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/covered_sum.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// 𝒮 cut at its mutual intersections, and the part of it that some of its segments cover.
struct Coverage {
  std::size_t pieces = 0;              ///< of 𝒮
  std::size_t pieces_left_out = 0;     ///< not covered by a segment of the same direction
  std::size_t points_left_out = 0;     ///< ends of pieces that are on no covering segment
  std::optional<Point> bare_boundary;  ///< a point left out that is not in the open sum
};

/// Tests one point inside each piece of 𝒮 (thesis, Definition 2.2.1) and each end of a piece,
/// except the `excepted` ones. That decides for all points of 𝒮, since coverage and membership in
/// the sum are constant inside a piece, and 𝒮 contains the boundary of the sum (Theorem 2.2.6).
/// Requires: covering is a subset of vertex_edge_sum(p, q).
Coverage coverage(const Summands& summands, const std::vector<ConvolutionSegment>& covering,
                  OpenSum& open_sum, const std::set<Point>& excepted) {
  const std::vector<ConvolutionSegment> all = vertex_edge_sum(summands.p, summands.q);
  const std::vector<std::vector<Segment>> pieces = cut_at_intersections(segments(all));
  std::set<Origin> covers;
  for (const ConvolutionSegment& s : covering) covers.insert(s.origin);

  // Pieces of overlapping segments are equal, so a piece is covered iff it is one of these.
  std::set<Segment> covered;
  std::set<Point> touched;
  std::set<Segment> every_piece;
  for (std::size_t i = 0; i < all.size(); ++i) {
    every_piece.insert(pieces[i].begin(), pieces[i].end());
    if (covers.count(all[i].origin) == 0) continue;
    for (const Segment& piece : pieces[i]) {
      covered.insert(piece);
      touched.insert(piece.source);
      touched.insert(piece.target);
    }
  }

  Coverage result;
  result.pieces = every_piece.size();
  std::set<Point> bare_ends;
  const auto look_at = [&](const Point& x) {
    if (!open_sum.contains(x) && !result.bare_boundary) result.bare_boundary = x;
  };
  for (const Segment& piece : every_piece) {
    if (covered.count(piece) == 0) {
      ++result.pieces_left_out;
      look_at(midpoint(piece.source, piece.target));
    }
    for (const Point& end : {piece.source, piece.target})
      if (touched.count(end) == 0) bare_ends.insert(end);
  }
  result.points_left_out = bare_ends.size();
  for (const Point& end : bare_ends) {
    if (excepted.count(end) == 0) look_at(end);
  }
  return result;
}

Outcome check_convolution_superset(const Summands& summands) {
  OpenSum open_sum(summands);
  const Coverage c = coverage(summands, convolution(summands.p, summands.q), open_sum, {});
  Outcome outcome;
  outcome.counts = {{"pieces of the vertex-edge sum", c.pieces},
                    {"pieces off the convolution", c.pieces_left_out},
                    {"points off the convolution", c.points_left_out}};
  if (c.bare_boundary) {
    outcome.fail("the boundary point " + to_string(*c.bare_boundary) +
                     " is on no segment of the convolution of the same direction",
                 *c.bare_boundary);
  }
  return outcome;
}

Outcome law_of_convolution_superset(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  return unless_broken(bare(sum(p, q), convolution(p, q), {}));
}

const Registered theorem_2_2_10(small_mixture(),
                                {.id = "theorem-2.2.10",
                                 .kills = {"parallel-edges-do-not-collide",
                                           "tangent-set-without-ties"},
                                 .cases = 200,
                                 .check = check_convolution_superset,
                                 .of_engine = for_one_engine(law_of_convolution_superset)});

/// The theorem as printed, for vertices that no other chain touches: no point inside a segment of a
/// reflex vertex is on the boundary.
Outcome check_reflex_segments(const Summands& summands, OpenSum& open_sum) {
  Outcome outcome;
  const auto touched_vertex = [](const Region& region) {
    return [all = chains(region), touching = touching_points(region)](const VertexIndex& index) {
      return std::binary_search(touching.begin(), touching.end(), all[index.chain][index.vertex]);
    };
  };
  const auto is_touched_of_p = touched_vertex(summands.p);
  const auto is_touched_of_q = touched_vertex(summands.q);
  const std::vector<ConvolutionSegment> all = vertex_edge_sum(summands.p, summands.q);
  const std::vector<std::vector<Segment>> pieces = cut_at_intersections(segments(all));
  const auto look_at = [&](const Point& x) {
    ++outcome.counts["points inside segments of reflex vertices"];
    if (outcome.kind == Outcome::Kind::fails || open_sum.contains(x)) return;
    outcome.fail("the boundary point " + to_string(x) + " is inside a segment of a reflex vertex",
                 x);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].vertex_is_reflex) continue;
    const auto& [edge_of, edge, vertex] = all[i].origin;
    if (edge_of == Summand::Q ? is_touched_of_p(vertex) : is_touched_of_q(vertex)) {
      ++outcome.counts["segments of reflex vertices that another chain touches, left out"];
      continue;
    }
    for (const Segment& piece : pieces[i]) {
      look_at(midpoint(piece.source, piece.target));
      if (piece.target != all[i].segment.target) look_at(piece.target);
    }
  }
  return outcome;
}

Outcome check_reduced_convolution_superset(const Summands& summands) {
  OpenSum open_sum(summands);
  Outcome outcome = check_reflex_segments(summands, open_sum);
  const std::set<Point> excepted = sums_of_touching_points(summands);
  const Coverage c =
      coverage(summands, reduced_convolution(summands.p, summands.q), open_sum, excepted);
  outcome.counts["sums of touching points of both summands, left out"] = excepted.size();
  outcome.counts["pieces off the reduced convolution"] = c.pieces_left_out;
  outcome.counts["points off the reduced convolution"] = c.points_left_out;
  if (c.bare_boundary && outcome.kind == Outcome::Kind::holds) {
    outcome.fail("the boundary point " + to_string(*c.bare_boundary) +
                     " is on no segment of the reduced convolution of the same direction",
                 *c.bare_boundary);
  }
  return outcome;
}

Outcome law_of_reduced_convolution_superset(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  return unless_broken(
      bare(sum(p, q), reduced_convolution(p, q), sums_of_touching_points(summands)));
}

const Registered theorem_2_3_2(small_mixture(),
                               {.id = "theorem-2.3.2",
                                .kills = {"acute-vertex-is-reflex", "tangent-set-without-ties"},
                                .cases = 80,
                                .check = check_reduced_convolution_superset,
                                .of_engine = for_one_engine(law_of_reduced_convolution_superset)});

}  // namespace

}  // namespace oplus
