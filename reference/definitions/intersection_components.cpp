// SPDX-License-Identifier: MIT
#include "reference/definitions/intersection_components.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <vector>

#include "reference/definitions/cells.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

[[maybe_unused]] bool some_vertex_touches(const Region& a, const Region& b) {
  const std::vector<Segment> of_a = edges(a), of_b = edges(b);
  return std::any_of(of_a.begin(), of_a.end(),
                     [&](const Segment& e) { return lies_on_one(e.source, of_b); });
}

/// How many connected parts the boundary of a face has.
std::size_t connected_parts(const std::vector<Segment>& boundary) {
  std::map<Point, std::size_t> number;
  for (const Segment& s : boundary) number.emplace(s.source, number.size());
  boost::disjoint_sets_with_storage<> parts(number.size());
  std::size_t result = number.size();
  for (const Segment& s : boundary) {
    const std::size_t a = number.at(s.source), b = number.at(s.target);
    if (parts.find_set(a) != parts.find_set(b)) --result;
    parts.union_set(a, b);
  }
  return result;
}

}  // namespace

ComponentsAndHoles intersection_components(const Region& p, const Region& q, const Point& x) {
  const Region moved_q = translated(reflected(q), x);
  OPLUS_REQUIRES(!some_vertex_touches(p, moved_q) && !some_vertex_touches(moved_q, p),
                 "general position, Section 4.2.2");
  std::vector<Segment> boundaries = edges(p);
  for (const Segment& e : edges(moved_q)) boundaries.push_back(e);
  ComponentsAndHoles result{0, 0};
  // Every edge has the outside of P or of -Q+x on one side, so that a face is a component.
  for (const std::vector<Segment>& boundary : cells(boundaries).faces) {
    if (boundary.empty()) continue;
    const Point inside = point_inside(boundary);
    if (locate(inside, p) != Location::inside || locate(inside, moved_q) != Location::inside)
      continue;
    ++result.components;
    if (!OPLUS_MUTANT("holes-of-an-intersection-are-not-seen",
                      "an intersection is taken for one without holes"))
      result.holes += connected_parts(boundary) - 1;
  }
  return result;
}

}  // namespace oplus
