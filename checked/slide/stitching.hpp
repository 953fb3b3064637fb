// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "checked/slide/boundary_pieces.hpp"
#include "checked/slide/integer_vector.hpp"
#include "checked/slide/short_list.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// A closed chain, from corner to corner.
struct StitchedChain {
  struct Edge {
    std::uint32_t from;           ///< the number of a point
    std::uint32_t first_segment;  ///< of those on which the edge runs, in `segments`
    std::uint32_t last_segment;   ///< behind these
  };
  std::vector<Edge> edges;
  std::vector<std::uint32_t> segments;
  bool is_outer = false;

  std::span<const std::uint32_t> segments_of(const Edge& edge) const {
    return {segments.begin() + edge.first_segment, segments.begin() + edge.last_segment};
  }
};

namespace detail {

/// Whether, turning counterclockwise from the way back along `in`, a is met before b: then a is the
/// larger clockwise turn (thesis, Definition 3.2.1). Neither is the way back.
template <typename Numbers>
bool turns_more_clockwise(const IntegerVector<Numbers>& in, const IntegerVector<Numbers>& a,
                          const IntegerVector<Numbers>& b) {
  const int turn_a = sign_of(cross(in, a)), turn_b = sign_of(cross(in, b));
  if (turn_a != turn_b) return turn_a < turn_b;
  return cross(a, b) > 0;
}

/// By how many full turns the direction changes along a chain, each corner less than half a turn
/// (thesis, Definition 2.1.9).
template <typename Directions>
int turning_number(const Directions& directions) {
  using Vector = typename Directions::value_type;
  const auto is_lower = [](const Vector& d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
  int turns = 0;
  const Vector* in = &directions.back();
  for (const Vector& out : directions) {
    const bool left = cross(*in, out) > 0;
    if (left && is_lower(*in) && !is_lower(out)) ++turns;
    if (!left && !is_lower(*in) && is_lower(out) &&
        !OPLUS_MUTANT("slide-sees-no-right-turn",
                      "the turning number of a chain counts left turns only"))
      --turns;
    in = &out;
  }
  return turns;
}

}  // namespace detail

/// Follows pieces to closed chains, turning clockwise most at each point (thesis, Definition 3.2.1).
/// Requires: the pieces are sorted and meet at common ends only, or are equal but for the segment;
/// direction(segment) is its direction as an IntegerVector.
template <typename Direction>
std::vector<StitchedChain> stitched(std::span<const BoundaryPiece> pieces, std::size_t points,
                                    const Direction& direction) {
  // Equal pieces are one, named by the first of them.
  ShortList<std::uint32_t> distinct;
  distinct.reserve(pieces.size());
  ShortList<std::uint32_t> leaving(points + 1, 0);
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (i > 0 && pieces[i - 1].from == pieces[i].from && pieces[i - 1].to == pieces[i].to) continue;
    distinct.push_back(i);
    ++leaving[pieces[i].from + 1];
  }
  for (std::size_t i = 0; i < points; ++i) leaving[i + 1] += leaving[i];
  const auto piece = [&](std::uint32_t k) -> const BoundaryPiece& { return pieces[distinct[k]]; };
  const auto next = [&](std::uint32_t k) {
    const std::uint32_t at = piece(k).to;
    std::uint32_t best = leaving[at];
    OPLUS_REQUIRES(best != leaving[at + 1], "Observation 3.2.4");
    for (std::uint32_t other = best + 1; other < leaving[at + 1]; ++other) {
      const bool is_better =
          detail::turns_more_clockwise(direction(piece(k).segment), direction(piece(other).segment),
                                       direction(piece(best).segment));
      if (is_better !=
          OPLUS_MUTANT(
              "slide-turns-counterclockwise-most",
              "where the boundary touches itself, slide's chains go round faces of the sum"))
        best = other;
    }
    return best;
  };

  std::vector<StitchedChain> chains;
  ShortList<char> visited(distinct.size(), false);
  ShortList<std::uint32_t> around;
  around.reserve(pieces.size());
  ShortList<std::decay_t<decltype(direction(0))>> directions;
  directions.reserve(pieces.size());
  for (std::uint32_t first = 0; first < distinct.size(); ++first) {
    if (visited[first]) continue;
    around.clear();
    std::uint32_t k = first;
    for (; !visited[k]; k = next(k)) {
      visited[k] = true;
      around.push_back(k);
    }
    OPLUS_REQUIRES(k == first, "Observation 3.2.4");
    directions.clear();
    for (const std::uint32_t i : around) directions.push_back(direction(piece(i).segment));
    const auto is_corner = [&](std::size_t i) {
      return cross(directions[i == 0 ? around.size() - 1 : i - 1], directions[i]) != 0;
    };
    // Start at a corner.
    std::size_t start = 0;
    while (!is_corner(start)) ++start;
    StitchedChain chain;
    chain.edges.reserve(around.size());
    chain.segments.reserve(around.size());
    for (std::size_t step = 0; step < around.size(); ++step) {
      const std::size_t i = (start + step) % around.size();
      const auto first_segment = static_cast<std::uint32_t>(chain.segments.size());
      if (is_corner(i)) chain.edges.push_back({piece(around[i]).from, first_segment, 0});
      const std::uint32_t end = around[i] + 1 < distinct.size()
                                    ? distinct[around[i] + 1]
                                    : static_cast<std::uint32_t>(pieces.size());
      for (std::uint32_t j = distinct[around[i]]; j < end; ++j)
        chain.segments.push_back(pieces[j].segment);
      chain.edges.back().last_segment = static_cast<std::uint32_t>(chain.segments.size());
    }
    chain.is_outer = detail::turning_number(directions) > 0;
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace oplus::slide
