// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter2/boundary_coverage.hpp"

#include "reference/definitions/cut_at_intersections.hpp"

namespace oplus {

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

}  // namespace oplus
