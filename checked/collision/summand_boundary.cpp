// SPDX-License-Identifier: MIT
#include "checked/collision/summand_boundary.hpp"

#include <utility>

#include "reference/chains/touching_points.hpp"

namespace oplus {

SummandBoundary::SummandBoundary(Region of) : region(std::move(of)) {
  for (const std::vector<Segment>& of_chain : pieces_by_chain(region)) {
    chain_of.insert(chain_of.end(), of_chain.size(), vertex_of_chain.size());
    vertex_of_chain.push_back(of_chain.front().source);
    pieces.insert(pieces.end(), of_chain.begin(), of_chain.end());
  }
}

TouchedChains untouched(const SummandBoundary& p, const SummandBoundary& minus_q) {
  return {std::vector<bool>(p.vertex_of_chain.size(), false),
          std::vector<bool>(minus_q.vertex_of_chain.size(), false)};
}

namespace {

/// Whether a chain that is not touched, moved by `by`, is inside the region.
bool contains_untouched_chain(const Region& region, const std::vector<Point>& vertex_of_chain,
                              const std::vector<bool>& touched, const Vector& by) {
  for (std::size_t chain = 0; chain < touched.size(); ++chain) {
    if (!touched[chain] && locate(vertex_of_chain[chain] + by, region) == Location::inside)
      return true;
  }
  return false;
}

}  // namespace

bool one_contains_untouched_chain(const SummandBoundary& p, const SummandBoundary& minus_q,
                                  const Point& x, const TouchedChains& touched) {
  return contains_untouched_chain(minus_q.region, p.vertex_of_chain, touched[0], -x) ||
         contains_untouched_chain(p.region, minus_q.vertex_of_chain, touched[1], x);
}

}  // namespace oplus
