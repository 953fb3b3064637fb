// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/places/overlay.hpp"
#include "reference/chains/validity.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// The two parts of a polygon cut along its first diagonal for which both parts are valid.
std::optional<std::vector<Region>> halves(const Chain& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    for (std::size_t j = i + 2; j < chain.size(); ++j) {
      const auto first = chain.begin() + static_cast<std::ptrdiff_t>(i);
      const auto last = chain.begin() + static_cast<std::ptrdiff_t>(j);
      Chain one(first, last + 1);
      Chain other(last, chain.end());
      other.insert(other.end(), chain.begin(), first + 1);
      if (other.size() < 3 || sign(twice_area(one)) <= 0 || sign(twice_area(other)) <= 0) continue;
      std::vector<Region> both = {polygon(std::move(one)), polygon(std::move(other))};
      if (!find_defect(both[0]) && !find_defect(both[1])) return both;
    }
  }
  return std::nullopt;
}

/// At least two regions whose union is the region; empty if none are found.
std::optional<std::vector<Region>> parts(const Region& region) {
  if (region.components.size() > 1) {
    std::vector<Region> components;
    for (const Component& component : region.components) components.push_back({{component}});
    return components;
  }
  const Component& only = region.components[0];
  return only.holes.empty() ? halves(only.outer) : std::nullopt;
}

Outcome broken(const Sum& sum, const Summands& summands, const std::vector<Region>& parts) {
  std::vector<MinkowskiSum> sums = {sum(summands.p, summands.q)};
  for (const Region& part : parts) sums.push_back(sum(part, summands.q));
  for (const OverlaidPoint& x : overlaid(sums)) {
    const bool in_whole = x.is_in(0, sum.is_open());
    bool in_a_part = false;
    for (std::size_t i = 1; i < sums.size(); ++i)
      in_a_part = in_a_part || x.is_in(i, sum.is_open());
    if (in_whole == in_a_part) continue;
    return Outcome().fail(
        to_string(x.point) + " is in the sum of " +
            (in_whole ? "the union and of no part" : "a part and not of the union"),
        x.point);
  }
  return {};
}

Outcome law(const Sum& sum, const Summands& summands) {
  const std::optional<std::vector<Region>> of_p = parts(summands.p);
  if (!of_p)
    return {Outcome::Kind::discarded,
            "P has one component and holes, or is a polygon without such a diagonal",
            {}};
  Outcome outcome = broken(sum, summands, *of_p);
  ++outcome
        .counts[summands.p.components.size() > 1 ? "unions of components" : "polygons cut in two"];
  return outcome;
}

const Registered registered({
    .id = "law-union",
    .sources = {{"components", 4, 4}, {"grid", 6, 3}, {"islands", 1, 1}, {"tight", 3, 1}},
    .promises = {{"several components", 15}, {"reflex vertices", 10}, {"parallel edges", 40}},
    .kills = {"candidates-need-no-hole-test", "dangling-edges-run-one-way"},
    .cases = 50,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
