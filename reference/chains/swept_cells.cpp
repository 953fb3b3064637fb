// SPDX-License-Identifier: MIT
#include "reference/chains/swept_cells.hpp"

#include <algorithm>

#include "reference/chains/plane_sweep.hpp"

namespace oplus {

std::vector<std::vector<Segment>> swept_pieces(const std::vector<Segment>& segments) {
  SweptEdges edges;
  for (const Segment& s : segments) edges.add(s);
  std::vector<std::vector<Segment>> pieces(segments.size());
  std::vector<Point> from(segments.size());  // where the last piece to the right starts
  sweep(edges, [&](const SweptPlace& place) {
    for (const std::uint32_t e : place.left) pieces[e].push_back({std::move(from[e]), place.point});
    for (const std::uint32_t e : place.right) from[e] = place.point;
    return true;
  });
  for (std::uint32_t e = 0; e < pieces.size(); ++e) {
    if (edges.runs_right(e)) continue;
    std::reverse(pieces[e].begin(), pieces[e].end());
    for (Segment& piece : pieces[e]) std::swap(piece.source, piece.target);
  }
  return pieces;
}

Cells swept_cells_of_pieces(const std::vector<std::vector<Segment>>& pieces) {
  return cells_of_pieces(pieces, [](const Cells& cells) {
    SweptEdges edges;
    for (const Point& vertex : cells.vertices) edges.add(vertex);
    for (const Cells::Edge& e : cells.edges)
      edges.edges.push_back(
          {static_cast<std::uint32_t>(e.source), static_cast<std::uint32_t>(e.target)});
    EdgesBelow result;
    sweep(edges, [&](const SweptPlace& place) {
      result.push_back(place.below);  // places are the vertices, in their order
      return true;
    });
    return result;
  });
}

Cells swept_cells(const std::vector<Segment>& segments) {
  return swept_cells_of_pieces(swept_pieces(segments));
}

}  // namespace oplus
