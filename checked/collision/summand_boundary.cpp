// SPDX-License-Identifier: MIT
#include "checked/collision/summand_boundary.hpp"

#include <algorithm>
#include <limits>
#include <optional>

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

/// From corner to corner of the box around chains.
std::vector<Segment> diagonal(const std::vector<std::vector<Segment>>& of_chains) {
  if (of_chains.empty()) return {};
  Point low = of_chains[0][0].source;
  Point high = low;
  for (const std::vector<Segment>& of_chain : of_chains) {
    for (const Segment& s : of_chain) {
      low = {std::min(low.x, s.source.x), std::min(low.y, s.source.y)};
      high = {std::max(high.x, s.source.x), std::max(high.y, s.source.y)};
    }
  }
  return {{low, high}};
}

bool is_above(const NearPoint& a, const NearPoint& b) {
  const std::optional<int> known = compare(a.near.y, b.near.y);
  return known ? *known > 0 : a.exact->y > b.exact->y;
}

/// A piece to the right of a point, from its lower to its upper end.
struct Crossed {
  NearPoint low;
  NearPoint high;
  bool runs_up;
};

/// Of two pieces that one ray crosses.
bool is_left_of(const Crossed& a, const Crossed& b) {
  if (is_above(b.low, a.low)) return !is_left_of(b, a);
  // They meet in ends at most.
  const int side = orientation(b.low, b.high, a.low);
  return (side != 0 ? side : orientation(b.low, b.high, a.high)) > 0;
}

}  // namespace

SummandBoundary::SummandBoundary(const Region& of) : SummandBoundary(pieces_by_chain(of)) {}

SummandBoundary::SummandBoundary(const std::vector<std::vector<Segment>>& of_chains)
    : pieces(joined(of_chains)), vertices(first_vertices(of_chains)), around(diagonal(of_chains)) {
  for (const std::vector<Segment>& of_chain : of_chains) {
    chain_of.insert(chain_of.end(), of_chain.size(), vertex_of_chain.size());
    vertex_of_chain.push_back(of_chain.front().source);
  }
}

bool SummandBoundary::contains(const Point& x) const {
  // The ray is an infinitesimal above x, so that it meets no vertex.
  const NearPoint from = near_point(x);
  const auto crossed = [&](std::size_t i) -> std::optional<Crossed> {
    const NearPoint source{pieces.certified(i).source, &pieces[i].source};
    const NearPoint target{pieces.certified(i).target, &pieces[i].target};
    const bool runs_up = is_above(target, from);
    if (is_above(source, from) == runs_up) return std::nullopt;
    const Crossed piece = runs_up ? Crossed{source, target, true} : Crossed{target, source, false};
    if (orientation(piece.low, piece.high, from) < 0) return std::nullopt;
    return piece;
  };
  std::optional<Crossed> first;
  double limit = std::numeric_limits<double>::max();
  pieces.look_for(
      limit,
      [&](const Box& box) {
        const bool may_cross = from.near.x.low <= box.high_x && box.low_y <= from.near.y.high &&
                               from.near.y.low <= box.high_y;
        return may_cross ? box.low_x : SegmentTree::nothing;
      },
      [&](std::size_t i) {
        const std::optional<Crossed> here = crossed(i);
        if (here && (!first || is_left_of(*here, *first))) {
          first = here;
          limit = std::max(here->low.near.x.high, here->high.near.x.high);
        }
        return limit;
      });
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
