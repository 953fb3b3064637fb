// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "checked/slide/boundary_pieces.hpp"
#include "checked/slide/integer_vector.hpp"
#include "checked/slide/parallel_for.hpp"
#include "checked/slide/short_list.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// Closed chains, each from corner to corner and rotated so that the numbers of its points are smallest,
/// in the order of these: the canonical order, where points are numbered in the order of the plane.
struct StitchedChains {
  struct Edge {
    std::uint32_t from;           ///< the number of a point
    std::uint32_t first_segment;  ///< of those on which the edge runs, in `segments`
    std::uint32_t last_segment;   ///< behind these
  };
  struct Chain {
    std::uint32_t first_edge;
    std::uint32_t last_edge;  ///< behind these
    bool is_outer;
  };
  ShortList<Chain> chains;
  ShortList<Edge> edges;
  ShortList<std::uint32_t> segments;

  std::span<const Edge> edges_of(const Chain& chain) const {
    return span_of(edges).subspan(chain.first_edge, chain.last_edge - chain.first_edge);
  }
  std::span<const std::uint32_t> segments_of(const Edge& edge) const {
    return span_of(segments).subspan(edge.first_segment, edge.last_segment - edge.first_segment);
  }
};

namespace detail {

/// Whether, turning counterclockwise from the way back along `in`, a is met before b: then a is the
/// larger clockwise turn (thesis, Definition 3.2.1). Neither is the way back.
template <typename Vector>
bool turns_more_clockwise(const Vector& in, const Vector& a, const Vector& b) {
  const int turn_a = turn(in, a), turn_b = turn(in, b);
  if (turn_a != turn_b) return turn_a < turn_b;
  return turn(a, b) > 0;
}

/// What a corner, less than half a turn, adds to the number of full turns of a chain: 1 where the
/// direction passes that of the x axis to the left, -1 to the right (thesis, Definition 2.1.9).
template <typename Vector>
int full_turns(const Vector& in, const Vector& out) {
  const bool lower_in = in.is_lower(), lower_out = out.is_lower();
  if (lower_in == lower_out) return 0;
  const bool left = turn(in, out) > 0;
  if (left && lower_in) return 1;
  if (!left && lower_out &&
      !OPLUS_MUTANT("slide-sees-no-right-turn",
                    "the turning number of a chain counts left turns only"))
    return -1;
  return 0;
}

/// Rotates the edges of a chain so that the numbers of their points are the smallest.
inline void rotate_to_smallest(std::span<StitchedChains::Edge> chain) {
  const std::size_t n = chain.size();
  const auto is_smaller = [&](std::size_t a, std::size_t b) {
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t of_a = chain[(a + k) % n].from, of_b = chain[(b + k) % n].from;
      if (of_a != of_b) return of_a < of_b;
    }
    return false;
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (chain[i].from < chain[best].from ||
        (chain[i].from == chain[best].from && is_smaller(i, best)))
      best = i;
  std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(best), chain.end());
}

}  // namespace detail

/// Follows pieces to closed chains, turning clockwise most at each point (thesis, Definition 3.2.1).
/// Requires: the pieces are sorted and meet at common ends only, or are equal but for the segment;
/// direction(segment) is its direction, with turn() and is_lower().
template <typename Direction>
StitchedChains stitched(std::span<const BoundaryPiece> pieces, std::size_t points,
                        const Direction& direction, unsigned threads) {
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
  // Which piece follows each, and how the boundary turns there.
  struct Step {
    std::uint32_t next;
    bool is_corner;
    std::int8_t full_turns;
  };
  ShortList<Step> steps(distinct.size());
  const auto step_from = [&](std::uint32_t k) -> Step {
    const std::uint32_t at = piece(k).to;
    const auto& in = direction(piece(k).segment);
    std::uint32_t best = leaving[at];
    OPLUS_REQUIRES(best != leaving[at + 1], "Observation 3.2.4");
    for (std::uint32_t other = best + 1; other < leaving[at + 1]; ++other) {
      const bool is_better = detail::turns_more_clockwise(in, direction(piece(other).segment),
                                                          direction(piece(best).segment));
      if (is_better !=
          OPLUS_MUTANT(
              "slide-turns-counterclockwise-most",
              "where the boundary touches itself, slide's chains go round faces of the sum"))
        best = other;
    }
    const auto& out = direction(piece(best).segment);
    return {best, turn(in, out) != 0, static_cast<std::int8_t>(detail::full_turns(in, out))};
  };
  for_each_part(distinct.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) steps[k] = step_from(static_cast<std::uint32_t>(k));
  });

  StitchedChains result;
  result.edges.reserve(distinct.size());
  result.segments.reserve(pieces.size());
  ShortList<char> visited(distinct.size(), false);
  for (std::uint32_t any = 0; any < distinct.size(); ++any) {
    if (visited[any]) continue;
    // Start at a corner.
    std::uint32_t start = any;
    while (!steps[start].is_corner) start = steps[start].next;
    start = steps[start].next;
    const auto first_edge = static_cast<std::uint32_t>(result.edges.size());
    bool is_corner = true;
    int turns = 0;
    std::uint32_t k = start;
    for (; !visited[k]; k = steps[k].next) {
      visited[k] = true;
      const auto first_segment = static_cast<std::uint32_t>(result.segments.size());
      if (is_corner) result.edges.push_back({piece(k).from, first_segment, 0});
      const std::uint32_t end =
          k + 1 < distinct.size() ? distinct[k + 1] : static_cast<std::uint32_t>(pieces.size());
      for (std::uint32_t j = distinct[k]; j < end; ++j)
        result.segments.push_back(pieces[j].segment);
      result.edges.back().last_segment = static_cast<std::uint32_t>(result.segments.size());
      is_corner = steps[k].is_corner;
      turns += steps[k].full_turns;
    }
    OPLUS_REQUIRES(k == start, "Observation 3.2.4");
    const auto last_edge = static_cast<std::uint32_t>(result.edges.size());
    detail::rotate_to_smallest(
        {result.edges.data() + first_edge, result.edges.size() - first_edge});
    result.chains.push_back({first_edge, last_edge, turns > 0});
  }
  std::sort(result.chains.begin(), result.chains.end(),
            [&](const StitchedChains::Chain& a, const StitchedChains::Chain& b) {
              const auto of_a = result.edges_of(a), of_b = result.edges_of(b);
              return std::lexicographical_compare(
                  of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                  [](const auto& e, const auto& f) { return e.from < f.from; });
            });
  return result;
}

}  // namespace oplus::slide
