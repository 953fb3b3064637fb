// SPDX-License-Identifier: MIT
#include "checked/rounding/faces.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reference/chains/region_of.hpp"
#include "reference/chains/swept_cells.hpp"
#include "reference/chains/touching_points.hpp"

namespace oplus {

Region region_with_connected_interiors(std::vector<Segment> edges) {
  for (Segment& e : edges) e = reversed(e);
  // Each chain of a sum bounds one face of the complement, here of the set.
  PlanarSet faces = canonical_sum(BoundaryFeatures{std::move(edges), {}, {}});
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

Region with_connected_interiors(const Region& region) {
  return touching_points(region).empty() ? region
                                         : region_with_connected_interiors(boundary_pieces(region));
}

Boundaries boundaries_of(const PlanarSet& set) {
  std::vector<Segment> segments;
  for (const std::vector<Chain>* chains : {&set.outer, &set.holes})
    for (const Chain& chain : *chains)
      std::ranges::move(edges(chain), std::back_inserter(segments));
  const std::vector<std::vector<Segment>> pieces = swept_pieces(segments);
  const Cells cells = swept_cells_of_pieces(pieces);

  Boundaries result;
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> numbers(cells.faces.size(), none);
  const auto number = [&](std::size_t face, std::size_t& count) {
    if (numbers[face] == none) numbers[face] = count++;
    return numbers[face];
  };
  for (const std::vector<Segment>& of_edge : pieces) {
    for (const Segment& piece : of_edge) {
      const bool forth = piece.source < piece.target;
      const Cells::Edge& edge = *std::ranges::lower_bound(
          cells.edges, forth ? piece : reversed(piece), {}, &Cells::Edge::segment);
      result.edges.push_back(piece);
      result.left.push_back(
          number(forth ? edge.left_face : edge.right_face, result.component_count));
      const std::size_t right = forth ? edge.right_face : edge.left_face;
      result.right.push_back(right == cells.unbounded_face ? none
                                                           : number(right, result.hole_count));
    }
  }
  std::ranges::replace(result.right, none, result.hole_count);
  return result;
}

}  // namespace oplus
