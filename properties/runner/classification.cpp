// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/classification.hpp"

#include <algorithm>
#include <compare>
#include <iterator>
#include <utility>
#include <vector>

#include "reference/definitions/convolution.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus {

namespace {

std::vector<Corner> corners(const Region& region) {
  std::vector<Corner> result;
  for (const Chain& chain : chains(region)) {
    for (std::size_t i = 0; i < chain.size(); ++i) result.push_back(corner_at(chain, i));
  }
  return result;
}

bool is_straight(const Corner& c) { return sign(cross(c.in, c.out)) == 0; }

/// The slope of a vector and, to tell the vertical ones apart, a 1 before it.
std::pair<int, Rational> slope(const Vector& v) {
  if (sign(v.x) == 0) return {1, 0};
  return {0, v.y / v.x};
}

std::vector<std::pair<int, Rational>> sorted_slopes(const Region& region) {
  std::vector<std::pair<int, Rational>> slopes;
  for (const Segment& e : edges(region)) slopes.push_back(slope(direction_of(e)));
  std::sort(slopes.begin(), slopes.end());
  return slopes;
}

bool some_parallel(const Region& p, const Region& q) {
  const auto of_p = sorted_slopes(p);
  const auto of_q = sorted_slopes(q);
  std::vector<std::pair<int, Rational>> common;
  std::set_intersection(of_p.begin(), of_p.end(), of_q.begin(), of_q.end(),
                        std::back_inserter(common));
  return !common.empty();
}

/// A segment under its line, so that those of one line stand together, from left to right.
struct OnLine {
  std::pair<int, Rational> slope;
  Rational intercept;
  Point low;
  Point high;

  explicit OnLine(const Segment& s)
      : slope(oplus::slope(direction_of(s))),
        intercept(slope.first == 1 ? s.source.x : Rational(s.source.y - slope.second * s.source.x)),
        low(std::min(s.source, s.target)),
        high(std::max(s.source, s.target)) {}

  bool same_line(const OnLine& other) const {
    return slope == other.slope && intercept == other.intercept;
  }
  friend std::weak_ordering operator<=>(const OnLine&, const OnLine&) = default;
};

bool some_overlap(const std::vector<ConvolutionSegment>& convolution) {
  std::vector<OnLine> sorted;
  for (const ConvolutionSegment& s : convolution) sorted.emplace_back(s.segment);
  std::sort(sorted.begin(), sorted.end());
  // If any two of a line overlap, some neighbours do: none between starts after the first ends.
  return std::adjacent_find(sorted.begin(), sorted.end(), [](const OnLine& a, const OnLine& b) {
           return a.same_line(b) && b.low < a.high;
         }) != sorted.end();
}

}  // namespace

Classification classify(const Summands& summands) {
  const Region& p = summands.p;
  const Region& q = summands.q;
  const std::vector<Corner> of_p = corners(p), of_q = corners(q);
  const auto has_holes = [](const Region& region) {
    return std::ranges::any_of(region.components,
                               [](const Component& c) { return !c.holes.empty(); });
  };
  const auto some = [](const std::vector<Corner>& all, bool (*is_so)(const Corner&)) {
    return std::ranges::any_of(all, is_so);
  };
  return {.holes = has_holes(p) || has_holes(q),
          .several_components = p.components.size() > 1 || q.components.size() > 1,
          .reflex_vertices = some(of_p, is_reflex) && some(of_q, is_reflex),
          .parallel_edges = some_parallel(p, q),
          .collinear_vertices = some(of_p, is_straight) || some(of_q, is_straight),
          .overlapping_segments = some_overlap(reduced_convolution(p, q))};
}

std::map<std::string, bool> named(const Classification& classification) {
  return {{"holes", classification.holes},
          {"several components", classification.several_components},
          {"reflex vertices", classification.reflex_vertices},
          {"parallel edges", classification.parallel_edges},
          {"collinear vertices", classification.collinear_vertices},
          {"overlapping segments", classification.overlapping_segments}};
}

}  // namespace oplus
