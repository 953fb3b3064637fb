// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/image.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

struct NamedMap {
  std::string name;
  AffineMap map;
};

std::vector<NamedMap> maps() {
  return {{"a quarter turn", {0, -1, 1, 0}},
          {"a reflection in the y-axis", {-1, 0, 0, 1}},
          {"x and y exchanged", {0, 1, 1, 0}},
          {"a shear", {1, 2, 0, 1}},
          {"a map that stretches and turns", {3, -1, 1, 2}}};
}

Outcome law(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  const MinkowskiSum here = sum(p, q);
  for (const auto& [name, map] : maps()) {
    const std::string what = told_apart(image(map, here), sum(image(map, p), image(map, q)));
    if (!what.empty()) return unless_broken("under " + name + ", " + what);
  }
  return {};
}

const Registered registered({
    .id = "law-linear",
    .sources = {{"grid", 7, 4},
                {"tight", 4, 2},
                {"holes", 5, 2},
                {"components", 4, 2},
                {"islands", 1, 1},
                {"fork", 2, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 15}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"left-and-right-are-one-direction", "vertical-edges-never-dangle"},
    .cases = 80,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
