// SPDX-License-Identifier: MIT
#include "checked/operations/operations.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "checked/operations/complement.hpp"
#include "checked/operations/image.hpp"
#include "checked/operations/inner_fit_in_convex.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"
#include "reference/definitions/unbounded.hpp"

namespace oplus {

namespace {

PlanarSet as_set(const Region& region) { return canonical_sum(region); }
const PlanarSet& as_set(const PlanarSet& set) { return set; }

Region opposite(const Region& region) { return reflected(region); }
PlanarSet opposite(const PlanarSet& set) { return image(scaled_by(-1), set); }

/// The boundary of a set that is one polygon, or null.
const Chain* only_chain(const Region& set) {
  const bool is_one = set.components.size() == 1 && set.components[0].holes.empty();
  return is_one && !is_unbounded(set) ? &set.components[0].outer : nullptr;
}
const Chain* only_chain(const PlanarSet& set) {
  const bool is_one = set.outer.size() == 1 && set.holes.empty() && set.dangling_edges.empty() &&
                      set.isolated_vertices.empty();
  return is_one && !set.is_unbounded ? &set.outer[0] : nullptr;
}

/// Points that a convex set contains iff it contains the set; none of an unbounded one.
std::vector<Point> points_of(const Region& set) {
  std::vector<Point> points;
  if (!is_unbounded(set)) each_vertex(set, [&](const Point& v) { points.push_back(v); });
  return points;
}
std::vector<Point> points_of(const PlanarSet& set) {
  std::vector<Point> points;
  if (set.is_unbounded) return points;
  for (const Segment& e : edges(set)) points.insert(points.end(), {e.source, e.target});
  points.insert(points.end(), set.isolated_vertices.begin(), set.isolated_vertices.end());
  return points;
}

// Of two regions, or of two closed sets.

template <typename Set, Boundary boundary>
PlanarSet sum_of(const Set& p, const Set& q, const SumOf& sum) {
  return unbounded_sum(p, q, boundary, sum);
}

template <typename Set>
PlanarSet no_fit_of(const Set& p, const Set& q, const SumOf& sum) {
  const bool is_not_turned = OPLUS_MUTANT(
      "no-fit-without-a-turn", "the no-fit polygon is the sum of P and Q, not of P and -Q");
  return unbounded_sum(p, is_not_turned ? q : opposite(q), Boundary::open, sum);
}

template <typename Set>
PlanarSet inner_fit_of(const Set& p, const Set& q, const SumOf& sum) {
  if (const Chain* chain = only_chain(p)) {
    if (const std::vector<Point> points = points_of(q); !points.empty())
      if (std::optional<PlanarSet> fit = inner_fit_in_convex(*chain, points))
        return *std::move(fit);
  }
  return complement(no_fit_of(complement(p), q, sum));
}

template <typename Set>
PlanarSet eroded_of(const Set& p, const Set& q, const SumOf& sum) {
  return regularized(inner_fit_of(p, q, sum));
}

template <typename Set>
PlanarSet opened_of(const Set& p, const Set& q, const SumOf& sum) {
  PlanarSet places = inner_fit_of(p, q, sum);
  if (OPLUS_MUTANT("openings-lose-exact-fits", "the opening lacks the copies of Q that just fit"))
    places = regularized(places);
  return unbounded_sum(places, as_set(q), Boundary::closed, sum);
}

template <typename Set>
PlanarSet closed_of(const Set& p, const Set& q, const SumOf& sum) {
  const PlanarSet dilated = unbounded_sum(p, q, Boundary::closed, sum);
  if (OPLUS_MUTANT("closing-does-not-erode", "the closing is the sum")) return dilated;
  return eroded_of(dilated, as_set(q), sum);
}

}  // namespace

PlanarSet no_fit(const Region& p, const Region& q, const SumOf& sum) {
  return no_fit_of(p, q, sum);
}

PlanarSet inner_fit(const Region& p, const Region& q, const SumOf& sum) {
  return inner_fit_of(p, q, sum);
}

PlanarSet eroded(const Region& p, const Region& q, const SumOf& sum) {
  return eroded_of(p, q, sum);
}

PlanarSet opened(const Region& p, const Region& q, const SumOf& sum) {
  return opened_of(p, q, sum);
}

PlanarSet closed(const Region& p, const Region& q, const SumOf& sum) {
  return closed_of(p, q, sum);
}

const std::vector<Operation>& operations() {
  static const std::vector<Operation> all = {
      {"nfp", "the no-fit polygon: all x where Q, moved by x, overlaps P", Boundary::open, no_fit,
       no_fit_of<PlanarSet>, true, true},
      {"ifp", "the inner-fit polygon: all x where Q, moved by x, is inside P", Boundary::closed,
       inner_fit, inner_fit_of<PlanarSet>, false, true},
      {"erode", "the erosion of P by Q: the inner-fit polygon without edges and points",
       Boundary::closed, eroded, eroded_of<PlanarSet>, false, false},
      {"open", "the opening: the union of all copies of Q, moved, inside P", Boundary::closed,
       opened, opened_of<PlanarSet>, false, false},
      {"close", "the closing: the erosion by Q of the sum of P and Q", Boundary::closed, closed,
       closed_of<PlanarSet>, false, false}};
  return all;
}

std::vector<std::string> operation_names() {
  std::vector<std::string> names = {"sum"};
  for (const Operation& operation : operations()) names.push_back(operation.name);
  return names;
}

const Operation& operation_called(const std::string& name, Boundary of_sum) {
  static const Operation closed_sum = {"sum",
                                       "all p + q",
                                       Boundary::closed,
                                       sum_of<Region, Boundary::closed>,
                                       sum_of<PlanarSet, Boundary::closed>,
                                       true,
                                       false};
  static const Operation open_sum = {"sum",
                                     "all p + q, of inner points",
                                     Boundary::open,
                                     sum_of<Region, Boundary::open>,
                                     sum_of<PlanarSet, Boundary::open>,
                                     true,
                                     false};
  if (name == "sum") return of_sum == Boundary::closed ? closed_sum : open_sum;
  const auto found = std::ranges::find(operations(), name, &Operation::name);
  if (found == operations().end()) throw std::invalid_argument("unknown operation " + name);
  return *found;
}

}  // namespace oplus
