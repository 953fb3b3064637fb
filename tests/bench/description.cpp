// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/description.hpp"

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

void Description::say(const std::vector<Segment>& segments) {
  for (const Segment& s : segments) said_ += to_string(s.source) + to_string(s.target);
  said_ += '\n';
}

void Description::add(const PlanarSet& sum, bool is_rounded) {
  const std::vector<Segment> all = edges(sum);
  count("sum_chains", sum.outer.size());
  count("sum_holes", sum.holes.size());
  count("sum_edges", all.size());
  count("sum_vertices", all.size() - sum.dangling_edges.size());
  count("sum_dangling", sum.dangling_edges.size());
  count("sum_isolated", sum.isolated_vertices.size());
  area_ = area_.value_or(0) + area(sum);
  if (is_rounded) return;
  say(all);
  for (const Point& p : sum.isolated_vertices) say(to_string(p));
  say("\n");
}

void Description::add(const std::vector<Chain>& chains, bool is_rounded) {
  PlanarSet as_they_are;
  BoundaryFeatures features;
  for (const Chain& chain : chains) {
    (twice_area(chain) > 0 ? as_they_are.outer : as_they_are.holes).push_back(chain);
    const std::vector<Segment> of_chain = edges(chain);
    features.edges.insert(features.edges.end(), of_chain.begin(), of_chain.end());
  }
  add(is_rounded ? as_they_are : canonical_sum(features), is_rounded);
}

std::string Description::label() const {
  std::ostringstream label;
  if (!said_.empty()) label << "digest=" << std::hex << std::hash<std::string>()(said_) << ' ';
  if (area_) label << "area=" << area_text(*area_);
  return label.str();
}

}  // namespace oplus
