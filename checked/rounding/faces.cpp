// SPDX-License-Identifier: MIT
#include "checked/rounding/faces.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "checked/slide/stitching.hpp"
#include "reference/arithmetic/interval.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/swept_cells.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

/// The direction from one point to another.
struct Way {
  const Point* from;
  const Point* to;

  IntervalPoint near() const { return interval(*to) - interval(*from); }
  /// Whether b is to the left of a, 1, or to the right, -1.
  friend int turn(const Way& a, const Way& b) {
    const std::optional<int> known = sign_of_cross(a.near(), b.near());
    return known ? *known : sign(cross(*a.to - *a.from, *b.to - *b.from));
  }
  /// Whether its angle is at least π.
  bool is_lower() const {
    const int up = cmp(to->y, from->y);
    return up < 0 || (up == 0 && to->x < from->x);
  }
};

}  // namespace

PlanarSet set_bounded_by(const std::vector<Point>& points, std::vector<NumberedEdge> edges) {
  std::ranges::sort(edges);
  std::vector<slide::BoundaryPiece> pieces;
  pieces.reserve(edges.size());
  for (const NumberedEdge& e : edges)
    pieces.push_back({e.from, e.to, static_cast<std::uint32_t>(pieces.size())});
  const slide::StitchedChains stitched = slide::stitched(
      pieces, points.size(),
      [&](std::uint32_t e) {
        return Way{&points[edges[e].from], &points[edges[e].to]};
      },
      1);
  PlanarSet result;
  for (const slide::StitchedChains::Chain& one : stitched.chains) {
    Chain& chain = (one.is_outer ? result.outer : result.holes).emplace_back();
    chain.reserve(one.last_edge - one.first_edge);
    for (const slide::StitchedChains::Edge& e : stitched.edges_of(one))
      chain.push_back(points[e.from]);
  }
  return result;
}

Region region_with_connected_interiors(const std::vector<Point>& points,
                                       std::vector<NumberedEdge> edges) {
  for (NumberedEdge& e : edges) std::swap(e.from, e.to);
  // Each chain of a sum bounds one face of the complement, here of the set.
  PlanarSet faces = set_bounded_by(points, std::move(edges));
  PlanarSet turned;
  for (std::vector<Chain>* chains : {&faces.outer, &faces.holes}) {
    for (Chain& chain : *chains) {
      std::reverse(chain.begin(), chain.end());
      turned.outer.push_back(std::move(chain));
    }
  }
  Region region = region_of(turned);
  const auto start_at_smallest = [](Chain& chain) {
    std::rotate(chain.begin(),
                chain.begin() + static_cast<std::ptrdiff_t>(start_of_smallest_rotation(chain)),
                chain.end());
  };
  for (Component& component : region.components) {
    start_at_smallest(component.outer);
    std::ranges::for_each(component.holes, start_at_smallest);
    std::ranges::sort(component.holes);
  }
  std::ranges::sort(region.components, {}, &Component::outer);
  return region;
}

Region with_connected_interiors(Region region) {
  if (touching_points(region).empty()) return region;
  const std::vector<Segment> pieces = boundary_pieces(region);
  std::vector<Point> points;
  for (const Segment& piece : pieces) points.push_back(piece.source);
  points = sorted_without_copies(std::move(points));
  const auto number = [&](const Point& p) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(points, p) - points.begin());
  };
  std::vector<NumberedEdge> edges;
  for (const Segment& piece : pieces) edges.push_back({number(piece.source), number(piece.target)});
  return region_with_connected_interiors(points, std::move(edges));
}

Boundaries boundaries_of(const PlanarSet& set) {
  SweptEdges swept;
  for (const std::vector<Chain>* chains : {&set.outer, &set.holes})
    for (const Chain& chain : *chains) swept.add(chain);
  std::vector<const Point*> places;
  const NumberedCells cells =
      numbered_cells(swept, [&](const SweptPlace& place) { places.push_back(&place.point); });
  Boundaries result;
  result.edges.reserve(cells.pieces.size());
  for (const auto& [from, to, above, below, edge] : cells.pieces) {
    if (swept.runs_right(edge))
      result.edges.push_back({places[from], places[to], above, below});
    else
      result.edges.push_back({places[to], places[from], below, above});
  }
  constexpr auto none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> numbers(cells.face_count, none);
  const auto number = [&](std::uint32_t f, std::uint32_t& count) {
    if (numbers[f] == none) numbers[f] = count++;
    return numbers[f];
  };
  for (Boundaries::Edge& e : result.edges) {
    e.left = number(e.left, result.component_count);
    e.right = e.right == 0 ? none : number(e.right, result.hole_count);
  }
  for (Boundaries::Edge& e : result.edges)
    if (e.right == none) e.right = result.hole_count;
  return result;
}

}  // namespace oplus
