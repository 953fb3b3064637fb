// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/families/rich_regions.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "reference/definitions/validity.hpp"
#include "reference/families/cells.hpp"
#include "reference/families/lattice_polygon.hpp"

namespace oplus {

namespace {

/// Makes room for integer points between.
Region doubled(Region region) {
  for (Component& component : region.components) {
    for (Point& p : component.outer) p = Rational(2) * p;
    for (Chain& hole : component.holes)
      for (Point& p : hole) p = Rational(2) * p;
  }
  return region;
}

bool has_hole(const Region& region) {
  return std::any_of(region.components.begin(), region.components.end(),
                     [](const Component& c) { return !c.holes.empty(); });
}

bool chains_within(const Region& region, std::size_t most) {
  const std::vector<Chain> all = chains(region);
  return std::all_of(all.begin(), all.end(), [&](const Chain& c) { return c.size() <= most; });
}

/// A random set of cells of a small square.
Region random_cells(Random& random, int side, int full_of_four) {
  Cells cells;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      if (uniform(random, 1, 4) <= full_of_four) cells.emplace(x, y);
  return region_of_cells(cells);
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
  if (most >= 4 && one_in(random, 4)) {
    for (int tries = 0; tries < 20; ++tries) {
      const Region region = random_cells(random, uniform(random, 3, 4), 3);
      if (region.components.size() == 1 && has_hole(region) &&
          chains_within(region, std::max<std::size_t>(most, 8)))
        return region;
    }
  }
  while (true) {
    Region region = polygon(lattice_polygon(random, uniform(random, 3, 5), most));
    if (one_in(random, 2)) region = doubled(std::move(region));
    cut_holes(random, region, most, uniform(random, 1, 3));
    if (has_hole(region)) return region;
  }
}

Region scattered_region(Random& random, std::size_t most) {
  if (most >= 4 && one_in(random, 4)) {
    for (int tries = 0; tries < 20; ++tries) {
      const Region region = random_cells(random, uniform(random, 3, 4), 2);
      if (region.components.size() > 1 && region.components.size() <= 4 &&
          chains_within(region, std::max<std::size_t>(most, 8)))
        return region;
    }
  }
  while (true) {
    Region region = one_in(random, 2) ? holed_region(random, most) : plain_region(random, most);
    if (one_in(random, 2)) region = doubled(std::move(region));
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

}  // namespace oplus
