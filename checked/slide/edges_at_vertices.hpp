// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numeric>

#include "checked/slide/integer_summand.hpp"
#include "checked/slide/short_list.hpp"
#include "reference/definitions/direction.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// A segment of the reduced convolution: an edge of one summand at a convex vertex of the other.
struct EdgeAtVertex {
  Summand edge_of;
  std::uint32_t edge;
  std::uint32_t vertex;
};

namespace detail {

/// The places of all edges' directions in counterclockwise order, ties as Definition 2.2.7 has them;
/// equal ones have the same. And the edges of each summand in that order, with the number of those before
/// each place.
struct Ranks {
  ShortList<std::uint32_t> of_p, of_q;
  ShortList<std::uint32_t> sorted_p, sorted_q;
  ShortList<std::uint32_t> before_p, before_q;
};

template <typename Numbers>
Ranks ranks(const IntegerSummand<Numbers>& p, const IntegerSummand<Numbers>& q) {
  struct Edge {
    double dx, dy;  ///< near its direction
    Summand of;
    bool lower;  ///< its angle is at least π
    std::uint32_t number;
  };
  ShortList<Edge> all;
  all.reserve(p.edges.size() + q.edges.size());
  const auto add = [&](const IntegerSummand<Numbers>& summand, Summand of) {
    for (std::uint32_t i = 0; i < summand.edges.size(); ++i) {
      const EdgeDirection<Numbers> d = summand.direction(i);
      all.push_back({d.near.dx, d.near.dy, of, d.is_lower(), i});
    }
  };
  add(p, Summand::P);
  add(q, Summand::Q);
  const auto direction = [&](const Edge& edge) {
    return (edge.of == Summand::P ? p : q).direction(edge.number);
  };
  static const int p_and_q = compare(Direction{{1, 0}, Summand::P}, Direction{{1, 0}, Summand::Q});
  const auto compared = [&](const Edge& a, const Edge& b) {
    if (a.lower != b.lower) return a.lower ? 1 : -1;
    int sign = certain_turn(b.dx, b.dy, a.dx, a.dy);
    if (sign == 0) sign = turn(direction(b).exact, direction(a).exact);
    if (sign != 0 || a.of == b.of ||
        OPLUS_MUTANT("slide-ranks-without-ties", "equal directions of P and Q have one rank"))
      return sign;
    return a.of == Summand::P ? p_and_q : -p_and_q;
  };
  std::sort(all.begin(), all.end(),
            [&](const Edge& a, const Edge& b) { return compared(a, b) < 0; });
  Ranks ranks;
  ranks.of_p.resize(p.edges.size());
  ranks.of_q.resize(q.edges.size());
  ranks.sorted_p.reserve(p.edges.size());
  ranks.sorted_q.reserve(q.edges.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k == 0 || compared(all[k - 1], all[k]) != 0) {
      ranks.before_p.push_back(static_cast<std::uint32_t>(ranks.sorted_p.size()));
      ranks.before_q.push_back(static_cast<std::uint32_t>(ranks.sorted_q.size()));
    }
    const auto rank = static_cast<std::uint32_t>(ranks.before_p.size() - 1);
    const bool is_of_p = all[k].of == Summand::P;
    (is_of_p ? ranks.of_p : ranks.of_q)[all[k].number] = rank;
    (is_of_p ? ranks.sorted_p : ranks.sorted_q).push_back(all[k].number);
  }
  return ranks;
}

}  // namespace detail

/// The reduced convolution, vertex by vertex along the boundary, and at each vertex edge by edge: so
/// that neighbours are near each other. O((n + m + K) log(n + m + K)).
template <typename Numbers>
ShortList<EdgeAtVertex> edges_at_vertices(const IntegerSummand<Numbers>& p,
                                          const IntegerSummand<Numbers>& q) {
  const detail::Ranks ranks = detail::ranks(p, q);
  ShortList<EdgeAtVertex> segments;
  const auto add = [&](const IntegerSummand<Numbers>& at, const ShortList<std::uint32_t>& ranks_at,
                       Summand edge_of, const ShortList<std::uint32_t>& sorted,
                       const ShortList<std::uint32_t>& before) {
    for (std::uint32_t v = 0; v < at.edges.size(); ++v) {
      const std::uint32_t entering = at.previous[v];
      if (turn(at.direction(entering), at.direction(v)) <= 0) continue;
      const auto from = sorted.begin() + before[ranks_at[entering]];
      const auto to = sorted.begin() + before[ranks_at[v]];
      const std::size_t begin = segments.size();
      const auto take = [&](auto edge, auto end) {
        for (; edge != end; ++edge) segments.push_back({edge_of, *edge, v});
      };
      if (ranks_at[entering] < ranks_at[v]) {
        take(from, to);
      } else {
        take(from, sorted.end());
        take(sorted.begin(), to);
      }
      std::sort(segments.begin() + static_cast<std::ptrdiff_t>(begin), segments.end(),
                [](const EdgeAtVertex& a, const EdgeAtVertex& b) { return a.edge < b.edge; });
    }
  };
  add(p, ranks.of_p, Summand::Q, ranks.sorted_q, ranks.before_q);
  add(q, ranks.of_q, Summand::P, ranks.sorted_p, ranks.before_p);
  return segments;
}

}  // namespace oplus::slide
