// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/described_sums.hpp"

#include <functional>
#include <sstream>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// An exact area of a large sum has thousands of digits.
std::string area_text(const Rational& area) {
  constexpr std::size_t long_text = 100;
  constexpr int decimals = 30;
  std::string exact = to_string(area);
  return exact.size() <= long_text ? exact : to_string(area, decimals);
}

}  // namespace

std::string digest_of(const std::string& text) {
  std::ostringstream digits;
  digits << std::hex << std::hash<std::string>()(text);
  return digits.str();
}

void describe_sums(const std::vector<MinkowskiSum>& sums, bool rounded, Measurement& measurement) {
  std::string said;
  Rational whole_area = 0;
  std::map<std::string, double>& numbers = measurement.numbers;
  const auto count = [&](const std::string& name, std::size_t size) {
    numbers["sum_" + name] += static_cast<double>(size);
  };
  for (const MinkowskiSum& sum : sums) {
    count("chains", sum.outer.size());
    count("holes", sum.holes.size());
    count("edges", edges(sum).size());
    count("dangling", sum.dangling_edges.size());
    count("isolated", sum.isolated_vertices.size());
    whole_area += area(sum);
    for (const auto* chains : {&sum.outer, &sum.holes}) {
      for (const Chain& chain : *chains) {
        count("vertices", chain.size());
        for (const Point& p : chain) said += to_string(p);
        said += '|';
      }
    }
    for (const Segment& edge : sum.dangling_edges)
      said += to_string(edge.source) + to_string(edge.target) + '|';
    for (const Point& p : sum.isolated_vertices) said += to_string(p);
    said += '\n';
  }
  measurement.area = area_text(whole_area);
  if (!rounded) measurement.digest = digest_of(said);
}

}  // namespace oplus
