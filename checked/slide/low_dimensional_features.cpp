// SPDX-License-Identifier: MIT
#include "checked/slide/low_dimensional_features.hpp"

#include <algorithm>
#include <iterator>
#include <memory>

#include "checked/collision/collision_test.hpp"
#include "checked/collision/isolated_touching_points.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus::slide {

void Candidates::take(Candidates&& more) {
  pieces.insert(pieces.end(), std::make_move_iterator(more.pieces.begin()),
                std::make_move_iterator(more.pieces.end()));
  points.insert(points.end(), std::make_move_iterator(more.points.begin()),
                std::make_move_iterator(more.points.end()));
}

void add_low_dimensional_features(const Candidates& candidates, const Region& p, const Region& q,
                                  std::vector<Point> corners, MinkowskiSum& sum) {
  const std::unique_ptr<CollisionTest> collision = hierarchy_collision(p, q);
  const std::vector<Segment> boundary = edges(sum);
  for (const Candidates::Piece& piece : candidates.pieces) {
    if (collision->interiors_meet_at(piece.inside)) continue;
    sum.dangling_edges.push_back(piece.segment);
    corners.push_back(piece.segment.source);
    corners.push_back(piece.segment.target);
  }
  sum.dangling_edges = maximal_segments(std::move(sum.dangling_edges));
  corners = sorted_without_copies(std::move(corners));
  for (Point& x : sorted_without_copies(candidates.points)) {
    if (std::binary_search(corners.begin(), corners.end(), x) || collision->interiors_meet_at(x) ||
        lies_on_one(x, sum.dangling_edges) || lies_on_one(x, boundary))
      continue;
    sum.isolated_vertices.push_back(std::move(x));
  }
  for (Point& x : isolated_touching_points(
           p, q, [&](const Point& y) { return collision->interiors_meet_at(y); }, sum))
    sum.isolated_vertices.push_back(std::move(x));
  sum.isolated_vertices = sorted_without_copies(std::move(sum.isolated_vertices));
}

}  // namespace oplus::slide
