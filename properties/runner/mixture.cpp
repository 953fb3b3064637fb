// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"

namespace oplus {

namespace {

std::vector<Promise> all_promises() {
  return {{"holes", 15},          {"several components", 5}, {"reflex vertices", 10},
          {"parallel edges", 40}, {"collinear vertices", 5}, {"overlapping segments", 5}};
}

}  // namespace

Mixture small_mixture() {
  const std::vector<Source> sources = {{"grid", 8, 6},       {"tight", 2, 2},  {"holes", 4, 3},
                                       {"components", 3, 2}, {"convex", 8, 1}, {"star", 7, 1},
                                       {"simple", 7, 1}};
  return {sources, all_promises()};
}

Mixture larger_mixture() {
  const std::vector<Source> sources = {
      {"grid", 8, 6}, {"tight", 3, 2}, {"holes", 6, 3},   {"components", 5, 2}, {"islands", 2, 2},
      {"comb", 4, 1}, {"fork", 3, 1},  {"convex", 16, 1}, {"star", 16, 1},      {"simple", 16, 1}};
  return {sources, all_promises()};
}

Mixture tight_mixture() {
  const std::vector<Source> sources = {{"tight", 4, 6},   {"grid", 8, 3},
                                       {"holes", 4, 2},   {"components", 3, 1},
                                       {"islands", 1, 1}, {"diamond-u", 1, 1}};
  return {sources,
          {{"holes", 10},
           {"reflex vertices", 10},
           {"parallel edges", 40},
           {"overlapping segments", 5}}};
}

std::vector<Promise> usual_promises() {
  std::vector<Promise> promises = all_promises();
  std::erase_if(promises,
                [](const Promise& one) { return one.classification == "collinear vertices"; });
  return promises;
}

}  // namespace oplus
