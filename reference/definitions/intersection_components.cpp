// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/intersection_components.hpp"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/mpq_class.h>

#include <algorithm>
#include <vector>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using Kernel = CGAL::Simple_cartesian<Rational>;
using Set = CGAL::Polygon_set_2<Kernel>;

[[maybe_unused]] bool some_vertex_touches(const Region& a, const Region& b) {
  const std::vector<Segment> of_a = edges(a), of_b = edges(b);
  return std::any_of(of_a.begin(), of_a.end(),
                     [&](const Segment& e) { return lies_on_one(e.source, of_b); });
}

/// The polygon a chain bounds, counterclockwise, whichever way the chain runs.
Set::Polygon_2 polygon_of(const Chain& chain) {
  Set::Polygon_2 result;
  for (const Point& p : chain) result.push_back({p.x, p.y});
  if (twice_area(chain) < 0) result.reverse_orientation();
  return result;
}

/// A region is the symmetric difference of what its chains bound: they may touch, never cross.
Set set_of(const Region& region) {
  std::vector<Set::Polygon_2> bounded;
  for (const Chain& chain : chains(region)) bounded.push_back(polygon_of(chain));
  Set result;
  result.symmetric_difference(bounded.begin(), bounded.end());
  return result;
}

}  // namespace

ComponentsAndHoles intersection_components(const Region& p, const Region& q, const Point& x) {
  const Region moved_q = translated(reflected(q), x);
  OPLUS_REQUIRES(!some_vertex_touches(p, moved_q) && !some_vertex_touches(moved_q, p),
                 "general position, Section 4.2.2");
  Set common = set_of(p);
  common.intersection(set_of(moved_q));
  ComponentsAndHoles result{0, 0};
  const Set::Arrangement_2& arrangement = common.arrangement();
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    if (!face->contained()) continue;
    ++result.components;
    if (!OPLUS_MUTANT("holes-of-an-intersection-are-not-seen",
                      "an intersection is taken for one without holes"))
      result.holes += face->number_of_inner_ccbs();
  }
  return result;
}

}  // namespace oplus
