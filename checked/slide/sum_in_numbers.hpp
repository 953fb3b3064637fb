// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "checked/collision/segment_tree.hpp"
#include "checked/slide/all_free_pieces.hpp"
#include "checked/slide/kept_summands.hpp"
#include "checked/slide/low_dimensional_features.hpp"
#include "checked/slide/named_ends.hpp"
#include "checked/slide/open_places.hpp"
#include "checked/slide/parallel_for.hpp"
#include "checked/slide/reduced_segments.hpp"
#include "checked/slide/search_statistics.hpp"
#include "checked/slide/stitching.hpp"
#include "checked/slide/sum_in.hpp"

namespace oplus::slide {

/// The steps of docs/slide.md after the segments: what no pair of edges blocks (3 to 5); these pieces, their ends
/// numbered, cut and stitched to chains, whose points become rationals again (6); of open sums also what has no area (7).
template <typename Numbers>
ComputedSum sum_of(ReducedSegments<Numbers>& segments, const Scaling& scaling, Boundary boundary,
                   const EngineOptions& options) {
  if (!options.with_origins) segments.leave_out_copies();
  std::optional<RaysOfBoth<Numbers>> rays;
  if (boundary == Boundary::open) rays.emplace(rays_of(segments.summands()));
  auto [pieces, open, effort] = all_free_pieces(segments, options, rays);

  if (boundary == Boundary::closed) segments.drop_boxes();
  const unsigned threads = options.threads;
  const std::size_t free_pieces = pieces.size();
  const NamedEnds<Numbers> ends = named_ends(std::move(pieces), segments, scaling, threads);
  const auto is_on = [&](std::uint32_t i, const BoundaryPiece& piece) {
    return lies_between(ends.points[i], ends.points[piece.from], ends.points[piece.to], scaling);
  };
  const std::vector<BoundaryPiece> cut = cut_at_points(
      span_of(ends.pieces), {is_on, span_of(ends.near_x), span_of(ends.near_y)}, threads);
  const StitchedChains stitched_chains = stitched(
      cut, ends.points.size(),
      [&](std::uint32_t segment) { return segments.edge_direction(segment); }, threads);

  ComputedSum result;
  const auto origins_of = [&](std::span<const std::uint32_t> numbers) {
    std::vector<Origin> origins;
    for (const std::uint32_t number : numbers) origins.push_back(segments.origin(number));
    std::sort(origins.begin(), origins.end());
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
    return origins;
  };
  for (const bool is_outer : {true, false}) {
    ShortList<StitchedChains::Chain> chains;
    std::copy_if(stitched_chains.chains.begin(), stitched_chains.chains.end(),
                 std::back_inserter(chains),
                 [&](const StitchedChains::Chain& chain) { return chain.is_outer == is_outer; });
    std::vector<Chain>& of_sum = is_outer ? result.sum.outer : result.sum.holes;
    of_sum.resize(chains.size());
    constexpr std::size_t chains_in_a_part = 512;
    // Most of the time goes into allocating the numbers of the points.
    for_each_part(
        chains.size(), threads,
        [&](std::size_t first, std::size_t last) {
          for (std::size_t k = first; k < last; ++k) {
            const auto edges = stitched_chains.edges_of(chains[k]);
            of_sum[k].resize(edges.size());
            for (std::size_t i = 0; i < edges.size(); ++i)
              ends.points[edges[i].from].put_into(of_sum[k][i], scaling);
          }
        },
        chains_in_a_part);
    if (options.with_origins)
      for (const StitchedChains::Chain& chain : chains)
        for (const StitchedChains::Edge& edge : stitched_chains.edges_of(chain))
          result.origins.push_back(origins_of(stitched_chains.segments_of(edge)));
  }

  if (boundary == Boundary::open) {
    LowDimensionalFeatures found = low_dimensional_features(
        segments, *rays,
        low_dimensional_candidates(segments, *rays, std::move(open), options.threads), ends,
        scaling, options.threads);
    result.sum.dangling_edges = std::move(found.dangling_edges);
    result.sum.isolated_vertices = std::move(found.isolated_vertices);
    if (options.with_origins && !result.sum.dangling_edges.empty()) {
      const SegmentTree edges(result.sum.dangling_edges);
      std::vector<std::vector<std::uint32_t>> along(edges.size());
      for (std::uint32_t i = 0; i < segments.size(); ++i) {
        const Segment segment = in_the_plane(segments[i], scaling);
        for (const std::size_t edge : oplus::near(segment, edges))
          if (overlap(segment, edges[edge])) along[edge].push_back(i);
      }
      for (const std::vector<std::uint32_t>& numbers : along)
        result.origins.push_back(origins_of(numbers));
    }
  }

  result.statistics =
      search_statistics(segments.size(), scaling.bits, free_pieces, effort, integers_of<Numbers>());
  return result;
}

template <typename Numbers>
ComputedSum sum_in(const Region& p, const Region& q, const Scaling& scaling, Boundary boundary,
                   const EngineOptions& options) {
  ReducedSegments<Numbers> segments(p, q, scaling, options.threads);
  return sum_of(segments, scaling, boundary, options);
}

template <typename Numbers>
ComputedSum sum_in(const PreparedSummand& p, const PreparedSummand& q, const Scaling& scaling,
                   Boundary boundary, const EngineOptions& options) {
  const auto kept_p = p.kept().in<Numbers>(p.region(), scaling, scaling.of_p);
  const auto kept_q = q.kept().in<Numbers>(q.region(), scaling, scaling.of_q);
  ReducedSegments<Numbers> segments(*kept_p, *kept_q, scaling, options.threads);
  return sum_of(segments, scaling, boundary, options);
}

}  // namespace oplus::slide
