// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/touching_exteriors.hpp"

#include <optional>

#include "reference/chains/touching_points.hpp"
#include "reference/definitions/direction.hpp"

namespace oplus {

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
