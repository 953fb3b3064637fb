// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/union_of.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// P and Q as they are, which mostly overlap; with a vertex of Q on one of P; and P with itself, moved along
/// its first edge, so that walls are shared.
std::vector<std::vector<Region>> overlapping(const Summands& summands) {
  const auto& [p, q] = summands;
  const Chain &of_p = p.components[0].outer, &of_q = q.components[0].outer;
  return {{p, q},
          {p, translated(q, of_p[1] - of_q[0])},
          {p, translated(p, of_p[1] - of_p[0]), translated(p, of_p[2] - of_p[0])}};
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  for (const std::vector<Region>& polygons : overlapping(summands)) {
    Region all;
    std::vector<PlanarSet> sets;
    for (const Region& one : polygons) {
      all = together(std::move(all), one);
      sets.push_back(canonical_sum(one));
    }
    const PlanarSet union_of_all = union_of(all);
    const Region region = region_of(union_of_all);
    if (const std::optional<Defect> defect = find_defect(region))
      return outcome.fail("the union is invalid: " + describe(defect->kind), defect->where);
    if (canonical_sum(region) != union_of_all)
      return outcome.fail("the union is not in canonical form: " + wkt(region));
    outcome.counts["unions with holes"] += has_hole(region);
    sets.push_back(union_of_all);
    for (const OverlaidPoint& x : overlaid(sets)) {
      std::size_t times = 0;
      for (std::size_t i = 0; i < polygons.size(); ++i) times += x.is_in(i, false);
      ++outcome.counts[times > 1    ? "points in several polygons"
                       : times == 1 ? "points in one polygon"
                                    : "points in none"];
      if (x.is_in(polygons.size(), false) != (times > 0))
        return outcome.fail(to_string(x.point) + " is in " + std::to_string(times) +
                                " polygons, and " + (times > 0 ? "not in" : "in") + " their union",
                            x.point);
    }
  }
  return outcome;
}

const Registered registered({
    .id = "fact-union",
    .sources =
        {{"grid", 8, 4}, {"holes", 4, 3}, {"components", 4, 2}, {"tight", 4, 2}, {"star", 8, 1}},
    .promises = {{"holes", 15}, {"several components", 10}, {"parallel edges", 40}},
    .kills = {"overlaps-are-no-part-of-unions", "unions-fill-holes"},
    .cases = 100,
    .check = check,
});

}  // namespace

}  // namespace oplus
