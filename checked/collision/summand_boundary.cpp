// SPDX-License-Identifier: MIT
#include "checked/collision/summand_boundary.hpp"

#include <algorithm>

#include "reference/definitions/winding_number.hpp"

#include "reference/chains/touching_points.hpp"

namespace oplus {

namespace {

std::vector<Segment> joined(const std::vector<std::vector<Segment>>& of_chains) {
  std::vector<Segment> all;
  for (const std::vector<Segment>& of_chain : of_chains)
    all.insert(all.end(), of_chain.begin(), of_chain.end());
  return all;
}

}  // namespace

SummandBoundary::SummandBoundary(const Region& of) : SummandBoundary(pieces_by_chain(of)) {}

SummandBoundary::SummandBoundary(const std::vector<std::vector<Segment>>& of_chains)
    : pieces(joined(of_chains)), hierarchy(pieces) {
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
  std::vector<Segment> met;
  const BoundingVolumeHierarchy ray({{x, {right_ + 1, x.y}}});
  hierarchy.visit_meeting(ray, {0, 0}, [&](std::size_t i, std::size_t) {
    met.push_back(pieces[i]);
    return false;
  });
  return winding_number(x, met) > 0;
}

TouchedChains untouched(const SummandBoundary& p, const SummandBoundary& minus_q) {
  return {std::vector<bool>(p.vertex_of_chain.size(), false),
          std::vector<bool>(minus_q.vertex_of_chain.size(), false)};
}

namespace {

/// Whether a chain that is not touched, moved by `by`, is inside a summand.
bool contains_untouched_chain(const SummandBoundary& summand,
                              const std::vector<Point>& vertex_of_chain,
                              const std::vector<bool>& touched, const Vector& by) {
  for (std::size_t chain = 0; chain < touched.size(); ++chain)
    if (!touched[chain] && summand.contains(vertex_of_chain[chain] + by)) return true;
  return false;
}

}  // namespace

bool one_contains_untouched_chain(const SummandBoundary& p, const SummandBoundary& minus_q,
                                  const Point& x, const TouchedChains& touched) {
  return contains_untouched_chain(minus_q, p.vertex_of_chain, touched[0], -x) ||
         contains_untouched_chain(p, minus_q.vertex_of_chain, touched[1], x);
}

}  // namespace oplus
