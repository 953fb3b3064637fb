// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/sweep/strands.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace oplus {

namespace {

/// Equal for two segments iff they lie on one line.
struct SupportingLine {
  explicit SupportingLine(const Segment& s) : is_vertical(s.source.x == s.target.x) {
    const Vector d = direction_of(s);
    if (!is_vertical) slope = d.y / d.x;
    offset = is_vertical ? s.source.x : Rational(s.source.y - slope * s.source.x);
  }

  friend bool operator<(const SupportingLine& a, const SupportingLine& b) {
    return std::tie(a.is_vertical, a.slope, a.offset) < std::tie(b.is_vertical, b.slope, b.offset);
  }

  bool is_vertical;
  Rational slope = 0;
  Rational offset;
};

/// Cuts the segments of one line at all their ends and joins equal pieces.
void add_strands(const std::vector<Segment>& segments, const std::vector<std::uint32_t>& of_line,
                 std::vector<Strand>& result) {
  std::set<Point> ends;
  for (const std::uint32_t i : of_line) ends.insert({segments[i].source, segments[i].target});
  std::map<Point, Strand> by_source;
  for (const std::uint32_t i : of_line) {
    const auto& [low, high] = std::minmax(segments[i].source, segments[i].target);
    const bool is_along = segments[i].source < segments[i].target;
    for (auto end = ends.find(low); *end != high; ++end) {
      Strand& strand = by_source[*end];
      strand.segment = {*end, *std::next(end)};
      (is_along ? strand.along : strand.against).push_back(i);
    }
  }
  for (auto& [source, strand] : by_source) result.push_back(std::move(strand));
}

}  // namespace

std::vector<Strand> strands(const std::vector<Segment>& segments) {
  std::map<SupportingLine, std::vector<std::uint32_t>> lines;
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    lines[SupportingLine(segments[i])].push_back(i);
  std::vector<Strand> result;
  for (const auto& [line, of_line] : lines) add_strands(segments, of_line, result);
  return result;
}

}  // namespace oplus
