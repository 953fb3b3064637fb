// SPDX-License-Identifier: MIT
#include "checked/slide/slide.hpp"

#include <algorithm>
#include <iterator>
#include <span>

#include "checked/slide/for_each_number.hpp"
#include "checked/slide/free_pieces.hpp"
#include "checked/slide/low_dimensional_candidates.hpp"
#include "checked/slide/named_ends.hpp"
#include "checked/slide/short_list.hpp"
#include "checked/slide/stitching.hpp"
#include "checked/slide/tracks.hpp"

namespace oplus {

namespace {

using namespace slide;

template <typename Numbers>
struct FoundPieces {
  ShortList<FreePiece<Numbers>> pieces;  ///< segment by segment
  SearchEffort effort;
};

/// Segments are independent. They are handed out in lots of the same size, whatever the number of
/// threads, so that neither the result nor the effort depends on it.
template <typename Numbers>
FoundPieces<Numbers> find_free_pieces(const Tracks<Numbers>& tracks, unsigned threads) {
  constexpr std::size_t in_a_lot = 128;
  constexpr std::size_t too_few = 8;  // to start threads for
  const auto find_in = [&](std::size_t lot, FoundPieces<Numbers>& found) {
    FreePieces<Numbers> search(tracks.summands());
    const std::size_t end = std::min((lot + 1) * in_a_lot, tracks.size());
    for (auto i = static_cast<std::uint32_t>(lot * in_a_lot); i < end; ++i)
      search.find(tracks[i], [&](Piece<Numbers> piece) {
        found.pieces.push_back({i, std::move(piece)});
      });
    found.effort = search.effort();
  };
  FoundPieces<Numbers> all;
  if (tracks.size() <= in_a_lot) {
    find_in(0, all);
    return all;
  }
  std::vector<FoundPieces<Numbers>> lots((tracks.size() + in_a_lot - 1) / in_a_lot);
  for_each_number(lots.size(), lots.size() < too_few ? 1 : threads,
                  [&](std::size_t lot) { find_in(lot, lots[lot]); });
  for (FoundPieces<Numbers>& lot : lots) {
    all.pieces.insert(all.pieces.end(), std::make_move_iterator(lot.pieces.begin()),
                      std::make_move_iterator(lot.pieces.end()));
    all.effort += lot.effort;
  }
  return all;
}

struct ChainWithOrigins {
  Chain chain;
  Origins origins;
};

/// `origins` of a chain's edge: whatever turns its segments into origins, or nothing.
template <typename PutPoint, typename OriginsOf>
ChainWithOrigins in_the_plane(const StitchedChain& stitched, const PutPoint& put_point,
                              const OriginsOf& origins_of, bool with_origins) {
  ChainWithOrigins result;
  result.chain.resize(stitched.edges.size());
  for (std::size_t i = 0; i < stitched.edges.size(); ++i)
    put_point(stitched.edges[i].from, result.chain[i]);
  if (with_origins)
    for (const StitchedChain::Edge& edge : stitched.edges)
      result.origins.push_back(origins_of(stitched.segments_of(edge)));
  const auto start = static_cast<std::ptrdiff_t>(start_of_smallest_rotation(result.chain));
  std::rotate(result.chain.begin(), result.chain.begin() + start, result.chain.end());
  if (with_origins)
    std::rotate(result.origins.begin(), result.origins.begin() + start, result.origins.end());
  return result;
}

void add(std::vector<ChainWithOrigins> chains, std::vector<Chain>& to, Origins& origins) {
  std::sort(chains.begin(), chains.end(),
            [](const auto& a, const auto& b) { return a.chain < b.chain; });
  for (ChainWithOrigins& chain : chains) {
    to.push_back(std::move(chain.chain));
    std::move(chain.origins.begin(), chain.origins.end(), std::back_inserter(origins));
  }
}

/// Which arithmetic the pairs of edges that took integers are counted for.
enum class Integers { of_64_bits, of_256_bits, of_gmp };

template <typename Numbers>
constexpr Integers integers_of() {
  if constexpr (is_small<Numbers>) return Integers::of_64_bits;
  if constexpr (std::is_same_v<Numbers, WideNumbers>) return Integers::of_256_bits;
  return Integers::of_gmp;
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
          {"in integers of GMP", decided_in(Integers::of_gmp)}};
}

template <typename Numbers>
ComputedSum sum_in(const Region& p, const Region& q, const Scaling& scaling, Boundary boundary,
                   const EngineOptions& options) {
  const Tracks<Numbers> tracks(p, q, scaling);
  const auto [pieces, effort] = find_free_pieces(tracks, options.threads);

  const NamedEnds<Numbers> ends = named_ends(pieces, tracks, scaling);
  const auto point = [&](std::uint32_t i) { return ends.points[i].in_the_plane(scaling); };
  const auto is_on = [&](std::uint32_t i, const BoundaryPiece& piece) {
    return lies_between(ends.points[i], ends.points[piece.from], ends.points[piece.to], scaling);
  };
  const std::vector<BoundaryPiece> cut =
      cut_at_points(ends.pieces, {point, is_on, ends.near_x, ends.near_y, margins(scaling).point});
  const std::vector<StitchedChain> chains = stitched(
      cut, ends.points.size(), [&](std::uint32_t segment) { return tracks.direction(segment); });

  ComputedSum result;
  const auto origins_of = [&](std::span<const std::uint32_t> segments) {
    std::vector<Origin> origins;
    for (const std::uint32_t segment : segments) origins.push_back(tracks.origin(segment));
    std::sort(origins.begin(), origins.end());
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
    return origins;
  };
  const auto put_point = [&](std::uint32_t i, Point& at) { ends.points[i].put_into(at, scaling); };
  std::vector<ChainWithOrigins> outer, holes;
  for (const StitchedChain& chain : chains)
    (chain.is_outer ? outer : holes)
        .push_back(in_the_plane(chain, put_point, origins_of, options.with_origins));
  add(std::move(outer), result.sum.outer, result.origins);
  add(std::move(holes), result.sum.holes, result.origins);

  if (boundary == Boundary::open) {
    std::vector<Point> corners;
    for (std::uint32_t i = 0; i < ends.points.size(); ++i) corners.push_back(point(i));
    add_low_dimensional_features(
        low_dimensional_candidates(tracks, pieces, scaling, options.threads), p, q,
        std::move(corners), result.sum);
    if (options.with_origins)
      for (const Segment& edge : result.sum.dangling_edges) {
        std::vector<std::uint32_t> along;
        for (std::uint32_t i = 0; i < tracks.size(); ++i)
          if (overlap(in_the_plane(tracks[i], scaling), edge)) along.push_back(i);
        result.origins.push_back(origins_of(along));
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
  const Scaling scaling = scaling_of(p, q);
  if (options.numbers == SlideNumbers::as_needed && scaling.bits <= SmallNumbers::bits)
    return sum_in<SmallNumbers>(p, q, scaling, boundary, options);
  if (options.numbers != SlideNumbers::gmp && scaling.bits <= WideNumbers::bits)
    return sum_in<WideNumbers>(p, q, scaling, boundary, options);
  return sum_in<AnyNumbers>(p, q, scaling, boundary, options);
}

}  // namespace oplus
