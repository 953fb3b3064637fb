// SPDX-License-Identifier: MIT
#include "checked/rounding/faces.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "reference/chains/nesting.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/touching_points.hpp"

namespace oplus {

namespace {

/// A chain of a region: the number of its component, and of its hole, counted through the region; an outer chain
/// has none.
struct ChainPlace {
  std::size_t component;
  std::optional<std::size_t> hole;
};

std::vector<ChainPlace> places_of_chains(const Region& region) {
  std::vector<ChainPlace> result;
  std::size_t holes = 0;
  for (std::size_t c = 0; c < region.components.size(); ++c) {
    result.push_back({c, std::nullopt});
    for (std::size_t h = 0; h < region.components[c].holes.size(); ++h)
      result.push_back({c, holes++});
  }
  return result;
}

/// The face of the complement that is around a chain of a region: its own, of a hole.
std::vector<std::size_t> faces_right_of_chains(const std::vector<ChainPlace>& places,
                                               const Nesting& nesting, std::size_t outside) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::optional<std::size_t> chain = i;
    while (chain && !places[*chain].hole) chain = nesting.around(*chain);
    result.push_back(chain ? *places[*chain].hole : outside);
  }
  return result;
}

}  // namespace

Region region_with_connected_interiors(std::vector<Segment> edges) {
  for (Segment& e : edges) e = reversed(e);
  // Each chain of a sum bounds one face of the complement, here of the set.
  MinkowskiSum faces = canonical_sum(BoundaryFeatures{std::move(edges), {}, {}});
  MinkowskiSum turned;
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

Boundaries boundaries_of(const MinkowskiSum& set) {
  // The same region but where chains touch; there they are cut, so that both have the same pieces.
  const Region by_holes = region_of(set), by_components = with_connected_interiors(by_holes);
  std::vector<std::pair<Segment, std::size_t>> components;
  std::vector<ChainPlace> places = places_of_chains(by_components);
  std::vector<std::vector<Segment>> pieces = pieces_by_chain(by_components);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (Segment& piece : pieces[i]) components.emplace_back(std::move(piece), places[i].component);
  std::ranges::sort(components);

  Boundaries result;
  result.component_count = by_components.components.size();
  places = places_of_chains(by_holes);
  for (const ChainPlace& place : places) result.hole_count += place.hole ? 1 : 0;
  const std::vector<std::size_t> right =
      faces_right_of_chains(places, nesting(SweptChains(chains_in(by_holes))), result.hole_count);
  pieces = pieces_by_chain(by_holes);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (Segment& piece : pieces[i]) {
      const auto same =
          std::ranges::lower_bound(components, piece, {}, &std::pair<Segment, std::size_t>::first);
      result.left.push_back(same->second);
      result.right.push_back(right[i]);
      result.edges.push_back(std::move(piece));
    }
  }
  return result;
}

}  // namespace oplus
