// SPDX-License-Identifier: MIT
#include "checked/slide/slide.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <optional>
#include <span>

#include "checked/slide/for_each_number.hpp"
#include "checked/slide/free_pieces.hpp"
#include "checked/slide/low_dimensional_features.hpp"
#include "checked/slide/named_ends.hpp"
#include "checked/slide/open_places.hpp"
#include "checked/slide/segments_along.hpp"
#include "checked/slide/short_list.hpp"
#include "checked/slide/stitching.hpp"
#include "checked/slide/tracks.hpp"

namespace oplus {

namespace {

using namespace slide;

template <typename Numbers>
struct FoundPieces {
  ShortList<FreePiece<Numbers>> pieces;  ///< segment by segment
  OpenCandidates<Numbers> open;          ///< where low-dimensional features may be
  SearchEffort effort;
};

/// Segments are independent. They are handed out in lots of the same size, whatever the number of
/// threads, so that neither the result nor the effort depends on it. With `rays`, for the open sum too.
template <typename Numbers>
FoundPieces<Numbers> find_free_pieces(const Tracks<Numbers>& tracks, const EngineOptions& options,
                                      const std::optional<RaysOfBoth<Numbers>>& rays) {
  constexpr std::size_t in_a_lot = 128;
  constexpr std::size_t too_few = 8;  // to start threads for
  const bool all_ways = rays && !right_is_enough(*rays);
  std::atomic<std::size_t> done = 0;
  const auto find_in = [&](std::size_t lot, FoundPieces<Numbers>& found) {
    FreePieces<Numbers> search(tracks.summands());
    std::optional<OpenPlaces<Numbers>> open;
    if (rays) open.emplace(tracks.summands(), *rays);
    const std::size_t end = std::min((lot + 1) * in_a_lot, tracks.size());
    for (auto i = static_cast<std::uint32_t>(lot * in_a_lot); i < end; ++i) {
      const auto add = [&](Piece<Numbers> piece) { found.pieces.push_back({i, std::move(piece)}); };
      if (open && (all_ways || is_to_the_right(tracks.direction(i))))
        open->find(search, i, tracks[i], add);
      else
        search.find(tracks[i], add);
    }
    found.effort = search.effort();
    if (open) found.open = std::move(open->found);
    if (options.progress) options.progress(done += end - lot * in_a_lot, tracks.size());
  };
  FoundPieces<Numbers> all;
  if (tracks.size() <= in_a_lot) {
    find_in(0, all);
    return all;
  }
  std::vector<FoundPieces<Numbers>> lots((tracks.size() + in_a_lot - 1) / in_a_lot);
  for_each_number(lots.size(), lots.size() < too_few ? 1 : options.threads,
                  [&](std::size_t lot) { find_in(lot, lots[lot]); });
  for (FoundPieces<Numbers>& lot : lots) {
    all.pieces.insert(all.pieces.end(), std::make_move_iterator(lot.pieces.begin()),
                      std::make_move_iterator(lot.pieces.end()));
    all.open.take(std::move(lot.open));
    all.effort += lot.effort;
  }
  return all;
}

/// Which arithmetic the pairs of edges that took integers are counted for.
enum class Integers { of_64_bits, of_256_bits, of_gmp, rationals };

template <typename Numbers>
constexpr Integers integers_of() {
  if constexpr (is_small<Numbers>) return Integers::of_64_bits;
  if constexpr (std::is_same_v<Numbers, WideNumbers>) return Integers::of_256_bits;
  return is_rational<Numbers> ? Integers::rationals : Integers::of_gmp;
}

Statistics statistics(std::size_t segments, std::size_t bits, std::size_t free_pieces,
                      const SearchEffort& effort, Integers integers) {
  const auto decided_in = [&](Integers these) {
    return these == integers ? effort.by_integers : std::size_t{0};
  };
  return {{"segments slid along", segments},
          {"bits of a coordinate", bits},
          {"free pieces of segments", free_pieces},
          {"probes", effort.probes},
          {"pairs of boxes", effort.box_pairs},
          {"pairs of edges decided by doubles", effort.by_doubles},
          {"in integers of 64 bits", decided_in(Integers::of_64_bits)},
          {"in integers of 256 bits", decided_in(Integers::of_256_bits)},
          {"in integers of GMP", decided_in(Integers::of_gmp)},
          {"in rationals", decided_in(Integers::rationals)}};
}

template <typename Numbers>
ComputedSum sum_in(const Region& p, const Region& q, const Scaling& scaling, Boundary boundary,
                   const EngineOptions& options) {
  Tracks<Numbers> tracks(p, q, scaling);
  std::optional<RaysOfBoth<Numbers>> rays;
  if (boundary == Boundary::open) {
    tracks.prepare_boxes();
    rays.emplace(rays_of(tracks.summands()));
  }
  auto [pieces, open, effort] = find_free_pieces(tracks, options, rays);

  const unsigned threads = options.threads;
  const NamedEnds<Numbers> ends = named_ends(pieces, tracks, scaling, threads);
  const auto is_on = [&](std::uint32_t i, const BoundaryPiece& piece) {
    return lies_between(ends.points[i], ends.points[piece.from], ends.points[piece.to], scaling);
  };
  const std::vector<BoundaryPiece> cut =
      cut_at_points(ends.pieces, {is_on, ends.near_x, ends.near_y}, threads);
  const StitchedChains stitched_chains = stitched(
      cut, ends.points.size(),
      [&](std::uint32_t segment) -> const IntegerVector<Numbers>& {
        return tracks.direction(segment);
      },
      threads);

  ComputedSum result;
  const auto origins_of = [&](std::span<const std::uint32_t> segments) {
    std::vector<Origin> origins;
    for (const std::uint32_t segment : segments) origins.push_back(tracks.origin(segment));
    std::sort(origins.begin(), origins.end());
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
    return origins;
  };
  for (const bool is_outer : {true, false}) {
    std::vector<StitchedChains::Chain> chains;
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
        tracks, *rays, low_dimensional_candidates(tracks, *rays, std::move(open), options.threads),
        ends, scaling, options.threads);
    result.sum.dangling_edges = std::move(found.dangling_edges);
    result.sum.isolated_vertices = std::move(found.isolated_vertices);
    if (options.with_origins && !result.sum.dangling_edges.empty()) {
      const SegmentsAlong<Numbers> segments(tracks, scaling);
      for (const Segment& edge : result.sum.dangling_edges)
        result.origins.push_back(origins_of(segments.along(edge)));
    }
  }

  result.statistics =
      statistics(tracks.size(), scaling.bits, pieces.size(), effort, integers_of<Numbers>());
  return result;
}

}  // namespace

ComputedSum slide_sum(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options) {
  if (p.components.empty() || q.components.empty())
    return {{}, {}, statistics(0, 0, 0, {}, Integers::of_64_bits)};
  if (options.numbers == SlideNumbers::rationals ||
      (options.numbers == SlideNumbers::as_needed && has_unlike_denominators(p, q)))
    return sum_in<RationalNumbers>(p, q, scaling_of_rationals(p, q), boundary, options);
  const Scaling scaling = scaling_of(p, q);
  if (options.numbers == SlideNumbers::as_needed && scaling.bits <= SmallNumbers::bits)
    return sum_in<SmallNumbers>(p, q, scaling, boundary, options);
  if (options.numbers != SlideNumbers::gmp && scaling.bits <= WideNumbers::bits)
    return sum_in<WideNumbers>(p, q, scaling, boundary, options);
  return sum_in<AnyNumbers>(p, q, scaling, boundary, options);
}

}  // namespace oplus
