// SPDX-License-Identifier: MIT
#include "reference/definitions/cut_at_intersections.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace oplus {

std::vector<std::vector<Segment>> cut_at_intersections(const std::vector<Segment>& segments) {
  std::vector<std::vector<Point>> met(segments.size());
  const auto low = [&](std::size_t i) -> const Rational& {
    return std::min(segments[i].source.x, segments[i].target.x);
  };
  const auto high = [&](std::size_t i) -> const Rational& {
    return std::max(segments[i].source.x, segments[i].target.x);
  };
  // Those that start to the right of where a segment ends don't meet it.
  std::vector<std::size_t> order(segments.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return low(i) < low(j); });
  for (auto i = order.begin(); i != order.end(); ++i) {
    for (auto j = i + 1; j != order.end() && low(*j) <= high(*i); ++j) {
      for (const Point& common : intersection(segments[*i], segments[*j])) {
        met[*i].push_back(common);
        met[*j].push_back(common);
      }
    }
  }
  std::vector<std::vector<Segment>> pieces;
  pieces.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    pieces.push_back(cut(segments[i], std::move(met[i])));
  return pieces;
}

std::vector<Segment> cut_where_met(const Segment& segment, const std::vector<Segment>& others) {
  std::vector<Point> met;
  for (const Segment& other : others) {
    const std::vector<Point> common = intersection(segment, other);
    met.insert(met.end(), common.begin(), common.end());
  }
  return cut(segment, std::move(met));
}

}  // namespace oplus
