// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/cut_at_intersections.hpp"

#include <utility>

namespace oplus {

std::vector<std::vector<Segment>> cut_at_intersections(const std::vector<Segment>& segments) {
  std::vector<std::vector<Point>> met(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      for (const Point& common : intersection(segments[i], segments[j])) {
        met[i].push_back(common);
        met[j].push_back(common);
      }
    }
  }
  std::vector<std::vector<Segment>> pieces;
  pieces.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    pieces.push_back(cut(segments[i], std::move(met[i])));
  return pieces;
}

}  // namespace oplus
