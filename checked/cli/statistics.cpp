// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/statistics.hpp"

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string text(std::size_t count) { return std::to_string(count); }

std::string text(Seconds seconds) { return std::to_string(seconds.count()); }

std::string text(const Rational& value) {
  const std::string exact = to_string(value);
  return exact.size() <= 60 ? exact : to_string(value, 6) + " (rounded)";
}

}  // namespace

Statistics statistics_of(const PlanarSet& sum) {
  return {{"outer chains", sum.outer.size()},
          {"holes", sum.holes.size()},
          {"dangling edges", sum.dangling_edges.size()},
          {"isolated vertices", sum.isolated_vertices.size()},
          {"area", area(sum)}};
}

std::string in_text(const Quantity& quantity) {
  return std::visit([](const auto& value) { return text(value); }, quantity);
}

}  // namespace oplus
