// SPDX-License-Identifier: MIT
#include "checked/collision/summand_boundary.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "reference/chains/touching_points.hpp"
#include "reference/definitions/exact_box.hpp"

namespace oplus {

namespace {

/// Takes the pieces of the chains.
std::vector<Segment> joined(std::vector<std::vector<Segment>> of_chains) {
  if (of_chains.size() == 1) return std::move(of_chains[0]);
  std::size_t count = 0;
  for (const std::vector<Segment>& of_chain : of_chains) count += of_chain.size();
  std::vector<Segment> all;
  all.reserve(count);
  for (std::vector<Segment>& of_chain : of_chains) {
    std::ranges::move(of_chain, std::back_inserter(all));
    of_chain = {};
  }
  return all;
}

std::vector<std::uint32_t> chains_of_pieces(const std::vector<std::vector<Segment>>& of_chains) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t c = 0; c < of_chains.size(); ++c)
    result.insert(result.end(), of_chains[c].size(), c);
  return result;
}

std::vector<Point> first_vertices(const std::vector<std::vector<Segment>>& of_chains) {
  std::vector<Point> all;
  for (const std::vector<Segment>& of_chain : of_chains) all.push_back(of_chain.front().source);
  return all;
}

std::vector<Segment> without_length(const std::vector<Point>& points) {
  std::vector<Segment> all;
  for (const Point& p : points) all.push_back({p, p});
  return all;
}

/// From corner to corner of the box around chains.
std::vector<Segment> diagonal(const std::vector<std::vector<Segment>>& of_chains) {
  if (of_chains.empty()) return {};
  ExactBox box(of_chains[0][0].source);
  for (const std::vector<Segment>& of_chain : of_chains)
    for (const Segment& s : of_chain) box.add(s.source);
  return {{box.low, box.high}};
}

}  // namespace

SummandBoundary::SummandBoundary(const Region& of) : SummandBoundary(pieces_by_chain(of)) {}

SummandBoundary::SummandBoundary(std::vector<std::vector<Segment>> of_chains)
    : chain_of(chains_of_pieces(of_chains)),
      vertex_of_chain(first_vertices(of_chains)),
      vertices(without_length(vertex_of_chain)),
      around(diagonal(of_chains)),
      pieces(joined(std::move(of_chains))) {}

bool SummandBoundary::contains(const Point& x) const {
  const std::optional<Crossing> first = first_to_the_right(x, pieces);
  return first && first->runs_up;
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
