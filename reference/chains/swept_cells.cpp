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

}  // namespace oplus
