// SPDX-License-Identifier: MIT
#include "reference/definitions/given_sum.hpp"

#include <optional>

#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

/// Whether a chain winds around another, which may touch it: one of the other's pieces decides.
bool is_around(const Chain& outer, const Chain& hole) {
  const std::vector<Segment> around = edges(outer);
  for (const Segment& piece : cut_edges(hole, outer)) {
    const Point middle = midpoint(piece.source, piece.target);
    if (!lies_on_one(middle, around)) return winding_number(middle, around) != 0;
  }
  return false;
}

}  // namespace

GivenSum given(const MinkowskiSum& sum) {
  GivenSum result{{}, sum.dangling_edges, sum.isolated_vertices};
  for (const Chain& outer : sum.outer) result.region.components.push_back({outer, {}});
  for (const Chain& hole : sum.holes) {
    std::optional<std::size_t> best;
    Rational least;
    for (std::size_t c = 0; c < sum.outer.size(); ++c) {
      if (!is_around(sum.outer[c], hole)) continue;
      const Rational area = abs(twice_area(sum.outer[c]));
      if (best && area >= least) continue;
      best = c;
      least = area;
    }
    if (best)
      result.region.components[*best].holes.push_back(hole);
    else
      result.region.components.push_back({{}, {hole}});
  }
  return result;
}

std::vector<GivenChain> given_chains(const GivenSum& sum) {
  std::vector<GivenChain> result;
  for (std::size_t c = 0; c < sum.region.components.size(); ++c) {
    const Component& component = sum.region.components[c];
    if (!component.outer.empty()) result.push_back({c + 1, 0, &component.outer});
    for (std::size_t h = 0; h < component.holes.size(); ++h)
      if (!component.holes[h].empty()) result.push_back({c + 1, h + 1, &component.holes[h]});
  }
  return result;
}

std::string describe(const GivenChain& chain) {
  return (chain.hole == 0 ? "the outer chain" : "hole " + std::to_string(chain.hole)) +
         " of component " + std::to_string(chain.component);
}

}  // namespace oplus
