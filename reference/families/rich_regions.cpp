// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/rich_regions.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/families/lattice_polygon.hpp"
#include "reference/families/pairs.hpp"

namespace oplus {

namespace {

/// Makes room for integer points between.
Region doubled(const Region& region) {
  return mapped(region, [](const Point& p) { return 2 * p; });
}

/// In one of four draws a random set of cells of a small square, if it is as wanted before long.
template <typename IsWanted>
std::optional<Region> region_of_random_cells(Random& random, std::size_t most, int full_of_four,
                                             IsWanted is_wanted) {
  if (most < 4 || !one_in(random, 4)) return std::nullopt;
  for (int tries = 0; tries < 20; ++tries) {
    const int side = uniform(random, 3, 4);
    Cells cells;
    for (int x = 0; x < side; ++x)
      for (int y = 0; y < side; ++y)
        if (uniform(random, 1, 4) <= full_of_four) cells.emplace(x, y);
    Region region = region_of_cells(cells);
    const std::vector<Chain> all = chains(region);
    const bool chains_are_short = std::all_of(all.begin(), all.end(), [&](const Chain& chain) {
      return chain.size() <= std::max<std::size_t>(most, 8);
    });
    if (is_wanted(region) && chains_are_short) return region;
  }
  return std::nullopt;
}

/// Cuts up to `wanted` random holes into the first component, where they leave the region valid.
void cut_holes(Random& random, Region& region, std::size_t most, int wanted) {
  for (int tries = 4 * wanted; tries > 0 && wanted > 0; --tries) {
    Component& component = region.components.front();
    std::optional<Chain> hole = lattice_polygon_within(random, component.outer, most);
    if (!hole) continue;
    component.holes.emplace_back(hole->rbegin(), hole->rend());
    if (find_defect(region))
      component.holes.pop_back();
    else
      --wanted;
  }
}

/// Adds a component if the region stays valid with it.
bool add(Region& region, Chain outer) {
  region.components.push_back({std::move(outer), {}});
  if (!find_defect(region)) return true;
  region.components.pop_back();
  return false;
}

/// Where to put another chain: somewhere near, or so that a vertex of it meets one that is there.
Vector offset_for(Random& random, const Region& region, const Chain& chain) {
  if (one_in(random, 2)) return {uniform(random, -6, 6), uniform(random, -6, 6)};
  const Chain& touched = region.components[uniform_index(random, region.components.size())].outer;
  const Point& onto = touched[uniform_index(random, touched.size())];
  return onto - chain[uniform_index(random, chain.size())];
}

}  // namespace

Region plain_region(Random& random, std::size_t most) {
  return polygon(lattice_polygon(random, uniform(random, 3, 6), most));
}

Region holed_region(Random& random, std::size_t most) {
  const auto is_wanted = [](const Region& region) {
    return region.components.size() == 1 && has_hole(region);
  };
  if (const auto region = region_of_random_cells(random, most, 3, is_wanted)) return *region;
  while (true) {
    Region region = polygon(lattice_polygon(random, uniform(random, 3, 5), most));
    if (one_in(random, 2)) region = doubled(region);
    cut_holes(random, region, most, uniform(random, 1, 3));
    if (has_hole(region)) return region;
  }
}

Region scattered_region(Random& random, std::size_t most) {
  const auto is_wanted = [](const Region& region) {
    return region.components.size() > 1 && region.components.size() <= 4;
  };
  if (const auto region = region_of_random_cells(random, most, 2, is_wanted)) return *region;
  while (true) {
    Region region = one_in(random, 2) ? holed_region(random, most) : plain_region(random, most);
    if (one_in(random, 2)) region = doubled(region);
    const std::size_t wanted = 2 + uniform_index(random, 3);
    for (int tries = 12; tries > 0 && region.components.size() < wanted; --tries) {
      const std::vector<Chain>& holes = region.components.front().holes;
      if (!holes.empty() && one_in(random, 2)) {
        const Chain& hole = holes[uniform_index(random, holes.size())];
        if (const auto island = lattice_polygon_within(random, hole, most)) add(region, *island);
        continue;
      }
      const Chain chain = lattice_polygon(random, uniform(random, 2, 4), most);
      add(region, translated(chain, offset_for(random, region, chain)));
    }
    if (region.components.size() > 1) return region;
  }
}

Summands holes_pair(Random& random, std::size_t n) {
  Region p = holed_region(random, n);
  Region q = one_in(random, 2) ? holed_region(random, n) : plain_region(random, n);
  return {std::move(p), std::move(q)};
}

Summands components_pair(Random& random, std::size_t n) {
  Region p = scattered_region(random, n);
  const int kind = uniform(random, 0, 3);
  Region q = kind == 0   ? scattered_region(random, n)
             : kind == 1 ? holed_region(random, n)
                         : plain_region(random, n);
  return {std::move(p), std::move(q)};
}

Region region_of_cells(const Cells& cells) {
  BoundaryFeatures boundary;
  const auto add_side = [&](const std::pair<int, int>& neighbour, const Segment& side) {
    if (!cells.contains(neighbour)) boundary.edges.push_back(side);
  };
  for (const auto& [x, y] : cells) {
    const Point a{x, y}, b{x + 1, y}, c{x + 1, y + 1}, d{x, y + 1};
    add_side({x, y - 1}, {a, b});
    add_side({x + 1, y}, {b, c});
    add_side({x, y + 1}, {c, d});
    add_side({x - 1, y}, {d, a});
  }
  return region_of(canonical_sum(boundary));
}

}  // namespace oplus
