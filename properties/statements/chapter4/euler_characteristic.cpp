// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/euler_characteristic.hpp"

#include <optional>

#include "checked/operations/image.hpp"
#include "properties/statements/chapter4/points_in_faces.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/direction.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::vector<Summands> with_covered_holes(const Summands& summands) {
  const auto& [p, q] = summands;
  std::vector<Summands> all{summands};
  if (has_hole(p) && !has_hole(q)) all.push_back({p, image(scaled_by(4), q)});
  if (has_hole(q) && !has_hole(p)) all.push_back({image(scaled_by(4), p), q});
  return all;
}

void count(const CountedIntersection& counted, Outcome& outcome) {
  ++outcome.counts["placements"];
  if (counted.of_interiors.components > 1) ++outcome.counts["intersections of several components"];
  if (counted.of_interiors.holes > 0) ++outcome.counts["intersections with holes"];
  if (counted.parted_exteriors > 0) ++outcome.counts["intersections with parted exteriors"];
}

}  // namespace

Outcome at_generic_placements(const Summands& summands,
                              const std::function<AtPlacement(const Summands& pair)>& of_pair) {
  Outcome outcome;
  for (const Summands& pair : with_covered_holes(summands)) {
    const IntersectionCounter counter(pair);
    const AtPlacement defect = of_pair(pair);
    for (const Point& x : generic_placements(pair)) {
      const CountedIntersection counted = counter.at(x);
      count(counted, outcome);
      const std::string what = defect(x, counted, outcome);
      if (!what.empty()) return outcome.fail("at " + to_string(x) + " " + what, x);
    }
  }
  return outcome;
}

Mixture pairs_with_holes() {
  Mixture mixture = small_mixture();
  mixture.sources = {{"grid", 8, 4},       {"tight", 3, 6},  {"holes", 4, 2},
                     {"components", 3, 2}, {"simple", 7, 1}, {"star", 7, 1}};
  return mixture;
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

std::string in_words(const CountedIntersection& found) {
  std::string words = counted(found.of_interiors.components, "component", "components") + " and " +
                      counted(found.of_interiors.holes, "hole", "holes");
  if (found.parted_exteriors != 0)
    words += ", exteriors parted by touching chains: " + std::to_string(found.parted_exteriors);
  return words;
}

namespace {

/// How a chain passes a point: the direction in which it goes on, and the direction back to where
/// it came from.
struct Passage {
  Vector out;
  Vector back;
};

std::optional<Passage> passage(const Chain& chain, const Point& at) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Point& source = chain[i];
    const Point& target = chain[next(i, chain.size())];
    if (source == at) return Passage{target - at, chain[previous(i, chain.size())] - at};
    if (target != at && lies_on(at, {source, target})) return Passage{target - at, source - at};
  }
  return std::nullopt;
}

/// The exterior to the right of a passage, going clockwise from its outgoing direction, ends at the
/// first passage met, which has that part of the exterior to its right as well.
std::size_t across_the_exterior(std::size_t from, const std::vector<Passage>& passages) {
  const Vector& start = passages[from].out;
  std::size_t first = from;
  for (std::size_t i = 0; i < passages.size(); ++i) {
    const Direction back{passages[i].back, Summand::P};
    if (counterclockwise_between(back, {passages[first].back, Summand::P}, {start, Summand::P}))
      first = i;
  }
  return first;
}

/// The parts of the exterior are the cycles of `across_the_exterior`.
int exteriors(const std::vector<Passage>& passages) {
  std::vector<bool> seen(passages.size(), false);
  int cycles = 0;
  for (std::size_t start = 0; start < passages.size(); ++start) {
    if (seen[start]) continue;
    ++cycles;
    for (std::size_t i = start; !seen[i]; i = across_the_exterior(i, passages)) seen[i] = true;
  }
  return cycles;
}

}  // namespace

std::vector<TouchingExteriors> touching_exteriors(const Region& region) {
  const std::vector<Chain> all = chains(region);
  std::vector<TouchingExteriors> result;
  for (const Point& at : touching_points(region)) {
    std::vector<Passage> passages;
    for (const Chain& chain : all) {
      if (const std::optional<Passage> p = passage(chain, at)) passages.push_back(*p);
    }
    result.push_back({at, exteriors(passages)});
  }
  return result;
}

}  // namespace oplus
