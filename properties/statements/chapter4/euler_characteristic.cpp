// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/euler_characteristic.hpp"

#include <algorithm>

namespace oplus {

namespace {

Region enlarged(const Region& region) {
  return mapped(region, [](const Point& p) { return 4 * p; });
}

}  // namespace

std::vector<Summands> with_covered_holes(const Summands& summands) {
  const auto& [p, q] = summands;
  std::vector<Summands> all{summands};
  if (has_hole(p) && !has_hole(q)) all.push_back({p, enlarged(q)});
  if (has_hole(q) && !has_hole(p)) all.push_back({enlarged(p), q});
  return all;
}

std::vector<Source> pairs_with_holes() {
  return {{"grid", 8, 4},       {"tight", 3, 6},  {"holes", 4, 2},
          {"components", 3, 2}, {"simple", 7, 1}, {"star", 7, 1}};
}

IntersectionCounter::IntersectionCounter(const Summands& summands)
    : p_(summands.p),
      q_(summands.q),
      touching_in_p_(touching_exteriors(p_)),
      touching_in_q_(touching_exteriors(q_)) {}

CountedIntersection IntersectionCounter::at(const Point& x) const {
  int parted = 0;
  for (const auto& [at, exteriors] : touching_in_p_)
    if (locate(x - at, q_) == Location::inside) parted += exteriors - 1;
  for (const auto& [at, exteriors] : touching_in_q_)
    if (locate(x - at, p_) == Location::inside) parted += exteriors - 1;
  return {intersection_components(p_, q_, x), parted};
}

std::string in_words(const CountedIntersection& counted) {
  std::string words = std::to_string(counted.of_interiors.components) + " components and " +
                      std::to_string(counted.of_interiors.holes) + " holes";
  if (counted.parted_exteriors != 0)
    words += " and touching chains part " + std::to_string(counted.parted_exteriors) + " exteriors";
  return words;
}

void count(const CountedIntersection& counted, Outcome& outcome) {
  ++outcome.counts["placements"];
  if (counted.of_interiors.components > 1) ++outcome.counts["intersections of several components"];
  if (counted.of_interiors.holes > 0) ++outcome.counts["intersections with holes"];
  if (counted.parted_exteriors > 0) ++outcome.counts["intersections with parted exteriors"];
}

}  // namespace oplus
