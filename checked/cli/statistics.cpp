// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/statistics.hpp"

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string legible(const Rational& value) {
  const std::string exact = to_string(value);
  return exact.size() <= 60 ? exact : to_string(value, 6) + " (rounded)";
}

}  // namespace

Statistics statistics_of(const MinkowskiSum& sum) {
  return {{"outer chains", std::to_string(sum.outer.size())},
          {"holes", std::to_string(sum.holes.size())},
          {"dangling edges", std::to_string(sum.dangling_edges.size())},
          {"isolated vertices", std::to_string(sum.isolated_vertices.size())},
          {"area", legible(area(sum))}};
}

}  // namespace oplus
