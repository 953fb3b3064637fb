// SPDX-License-Identifier: MIT
#include "reference/chains/swept_cells.hpp"

#include <algorithm>
#include <utility>

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

Cells swept_cells(const std::vector<Segment>& segments) {
  return cells_of_pieces(swept_pieces(segments), [](const Cells& cells) {
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

NumberedCells numbered_cells(const SweptEdges& edges,
                             const std::function<void(const SweptPlace&)>& see) {
  NumberedCells result;
  std::vector<NumberedCells::Piece> last(edges.edges.size());  // of each edge, to the right
  std::vector<std::uint32_t> whole = {0};  // of a face, the first one that it is a part of
  const auto face = [&](std::uint32_t f) {
    while (whole[f] != f) f = whole[f] = whole[whole[f]];
    return f;
  };
  std::uint32_t here = 0;
  sweep(edges, [&](const SweptPlace& place) {
    std::uint32_t below = place.below ? last[*place.below].above : 0, above = below;
    for (std::size_t i = 0; i < place.left.size(); ++i) {
      const std::uint32_t from = last[place.left[i]].from;
      std::size_t end = i + 1;  // pieces between the same places are equal
      while (end < place.left.size() && last[place.left[end]].from == from) ++end;
      const std::uint32_t lower = last[place.left[i]].below;
      above = last[place.left[end - 1]].above;
      for (; i < end; ++i) result.pieces.push_back({from, here, above, lower, place.left[i]});
      --i;
    }
    if (place.right.empty()) {
      const auto [first, second] = std::minmax({face(below), face(above)});
      whole[second] = first;
    }
    for (std::size_t i = 0; i < place.right.size(); ++i) {
      const bool is_highest = i + 1 == place.right.size();
      const std::uint32_t over = is_highest ? above : static_cast<std::uint32_t>(whole.size());
      if (!is_highest) whole.push_back(over);
      last[place.right[i]] = {here, here, over, below, place.right[i]};
      below = over;
    }
    see(place);
    ++here;
    return true;
  });
  // Faces between edges that overlap are none.
  std::vector<bool> is_seen(whole.size(), false);
  is_seen[0] = true;
  for (NumberedCells::Piece& piece : result.pieces) {
    is_seen[piece.above = face(piece.above)] = true;
    is_seen[piece.below = face(piece.below)] = true;
  }
  result.face_count = 0;
  for (std::size_t f = 0; f < whole.size(); ++f) whole[f] = is_seen[f] ? result.face_count++ : 0;
  for (NumberedCells::Piece& piece : result.pieces) {
    piece.above = whole[piece.above];
    piece.below = whole[piece.below];
  }
  return result;
}

}  // namespace oplus
