// SPDX-License-Identifier: MIT
#include "checked/verify/summand_parts.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "checked/pieces/convex_pieces.hpp"

namespace oplus::convex_parts {

namespace {

Line line_between(const Corner& a, const Corner& b) {
  const IntervalPoint along = b.near - a.near;
  return {&a, &b, is_exact(along.x) && is_exact(along.y) ? along : interval(b.point - a.point)};
}

}  // namespace

SummandParts::SummandParts(const Region& region) {
  pieces::ConvexPieces all = pieces::convex_pieces(region);
  std::size_t size = 0;
  for (const pieces::ConvexPiece& piece : all.pieces) size += piece.size();
  corners.reserve(all.vertices.size());
  for (Point& vertex : all.vertices) {
    const IntervalPoint near = interval(vertex);
    corners.push_back({std::move(vertex), near});
  }
  const auto add_chain = [&](const Chain& chain) {
    const std::size_t first = before.size();
    for (std::size_t i = 0; i < chain.size(); ++i) {
      before.push_back(first + previous(i, chain.size()));
      after.push_back(first + next(i, chain.size()));
    }
  };
  for (const Component& component : region.components) {
    add_chain(component.outer);
    for (const Chain& hole : component.holes) add_chain(hole);
  }
  lines.reserve(corners.size() + size);
  for (std::size_t e = 0; e < corners.size(); ++e)
    lines.push_back(line_between(corners[e], corners[after[e]]));

  std::unordered_map<std::uint64_t, const Line*> diagonals;
  std::vector<Box> boxes_around;
  sides.reserve(size);
  for (const pieces::ConvexPiece& piece : all.pieces) {
    pieces.push_back(
        {static_cast<std::uint32_t>(sides.size()), static_cast<std::uint32_t>(piece.size())});
    Box box;  // large enough for sums of two to be rounded
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const std::uint32_t from = piece[k], to = piece[next(k, piece.size())];
      box = around(box, enlarged(box_of(corners[from].near), 0));
      const Line* line = &lines[from];
      if (line->to != &corners[to]) {
        const Line*& known =
            diagonals[(std::uint64_t{std::min(from, to)} << 32) + std::max(from, to)];
        if (known == nullptr) known = &lines.emplace_back(line_between(corners[from], corners[to]));
        line = known;
      }
      sides.push_back({line, &corners[from]});
    }
    boxes_around.push_back(box);
  }
  boxes = BoxTree<>(boxes_around);
}

}  // namespace oplus::convex_parts
