// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"

namespace oplus {

std::vector<Source> small_mixture() {
  return {{"grid", 8, 6},   {"tight", 2, 2}, {"holes", 4, 3}, {"components", 3, 2},
          {"convex", 8, 1}, {"star", 7, 1},  {"simple", 7, 1}};
}

std::vector<Source> larger_mixture() {
  return {{"grid", 8, 6},    {"tight", 3, 2},  {"holes", 6, 3}, {"components", 5, 2},
          {"islands", 2, 2}, {"comb", 4, 1},   {"fork", 3, 1},  {"convex", 16, 1},
          {"star", 16, 1},   {"simple", 16, 1}};
}

std::vector<Promise> promises_of_mixture() {
  return {{"holes", 15},          {"several components", 5}, {"reflex vertices", 10},
          {"parallel edges", 40}, {"collinear vertices", 5}, {"overlapping segments", 5}};
}

}  // namespace oplus
