// SPDX-License-Identifier: MIT
#include "checked/collision/summand_boundary.hpp"

#include <algorithm>

#include "reference/chains/near_point.hpp"
#include "reference/chains/touching_points.hpp"

namespace oplus {

namespace {

std::vector<Segment> joined(const std::vector<std::vector<Segment>>& of_chains) {
  std::size_t count = 0;
  for (const std::vector<Segment>& of_chain : of_chains) count += of_chain.size();
  std::vector<Segment> all;
  all.reserve(count);
  for (const std::vector<Segment>& of_chain : of_chains)
    all.insert(all.end(), of_chain.begin(), of_chain.end());
  return all;
}

std::vector<Segment> first_vertices(const std::vector<std::vector<Segment>>& of_chains) {
  std::vector<Segment> all;
  for (const std::vector<Segment>& of_chain : of_chains)
    all.push_back({of_chain.front().source, of_chain.front().source});
  return all;
}

/// From corner to corner of the box around segments.
std::vector<Segment> diagonal(const std::vector<Segment>& segments) {
  if (segments.empty()) return {};
  Point low = segments[0].source;
  Point high = low;
  for (const Segment& s : segments) {
    for (const Point* end : {&s.source, &s.target}) {
      low = {std::min(low.x, end->x), std::min(low.y, end->y)};
      high = {std::max(high.x, end->x), std::max(high.y, end->y)};
    }
  }
  return {{low, high}};
}

}  // namespace

SummandBoundary::SummandBoundary(const Region& of) : SummandBoundary(pieces_by_chain(of)) {}

SummandBoundary::SummandBoundary(const std::vector<std::vector<Segment>>& of_chains)
    : pieces(joined(of_chains)),
      hierarchy(pieces),
      vertices(first_vertices(of_chains)),
      around(diagonal(pieces)) {
  for (const std::vector<Segment>& of_chain : of_chains) {
    chain_of.insert(chain_of.end(), of_chain.size(), vertex_of_chain.size());
    vertex_of_chain.push_back(of_chain.front().source);
  }
  if (pieces.empty()) return;
  right_ = std::max_element(pieces.begin(), pieces.end(), [](const Segment& a, const Segment& b) {
             return a.source.x < b.source.x;
           })->source.x;
}

bool SummandBoundary::contains(const Point& x) const {
  if (right_ < x.x) return false;
  int crossings = 0;  // as in winding_number
  const NearPoint near_x = near_point(x);
  const BoundingVolumeHierarchy ray({{x, {right_ + 1, x.y}}});
  hierarchy.visit_meeting(ray, {0, 0}, [&](std::size_t i, std::size_t) {
    const auto& [source, target] = pieces[i];
    const bool source_below = source.y <= x.y, target_below = target.y <= x.y;
    if (source_below == target_below) return false;
    const int side = orientation(near_point(source), near_point(target), near_x);
    crossings += (source_below && side > 0) - (target_below && side < 0);
    return false;
  });
  return crossings > 0;
}

TouchedChains untouched(const SummandBoundary& p, const SummandBoundary& minus_q) {
  return {std::vector<bool>(p.vertex_of_chain.size(), false),
          std::vector<bool>(minus_q.vertex_of_chain.size(), false)};
}

namespace {

/// Whether a chain of `other` that is not touched is inside a summand moved by `by`. Only chains with
/// their vertex in the box around that are looked at.
bool contains_untouched_chain(const SummandBoundary& summand, const SummandBoundary& other,
                              const std::vector<bool>& touched, const Vector& by) {
  return other.vertices.visit_meeting(summand.around, by, [&](std::size_t chain, std::size_t) {
    return !touched[chain] && summand.contains(other.vertex_of_chain[chain] - by);
  });
}

}  // namespace

bool one_contains_untouched_chain(const SummandBoundary& p, const SummandBoundary& minus_q,
                                  const Point& x, const TouchedChains& touched) {
  return contains_untouched_chain(minus_q, p, touched[0], x) ||
         contains_untouched_chain(p, minus_q, touched[1], -x);
}

}  // namespace oplus
