// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "checked/engine.hpp"
#include "checked/slide/free_pieces.hpp"
#include "checked/slide/open_places.hpp"
#include "checked/slide/parallel_for.hpp"
#include "checked/slide/reduced_segments.hpp"
#include "checked/slide/short_list.hpp"

namespace oplus::slide {

template <typename Numbers>
struct FoundPieces {
  ShortList<FreePiece<Numbers>> pieces;  ///< segment by segment
  OpenCandidates<Numbers> open;          ///< where low-dimensional features may be
  SearchEffort effort;
};

/// Segments are independent. They are handed out in lots of the same size, whatever the number of
/// threads, so that neither the result nor the effort depends on it. With `rays`, for the open sum too.
template <typename Numbers>
FoundPieces<Numbers> all_free_pieces(const ReducedSegments<Numbers>& segments,
                                     const EngineOptions& options,
                                     const std::optional<RaysOfBoth<Numbers>>& rays) {
  constexpr std::size_t too_few = 8;  // lots to start threads for
  const bool all_ways = rays && !right_is_enough(*rays);
  std::atomic<std::size_t> done = 0;
  const auto find_in = [&](std::size_t first, std::size_t last) {
    FoundPieces<Numbers> found;
    FreePieces<Numbers> search(segments.summands());
    std::optional<OpenPlaces<Numbers>> open;
    if (rays) open.emplace(segments.summands(), *rays);
    for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) {
      const auto add = [&](Piece<Numbers> piece) { found.pieces.push_back({i, std::move(piece)}); };
      if (open && (all_ways || is_to_the_right(segments.direction(i))))
        open->find(search, i, segments[i], add);
      else
        search.find(segments[i], add);
    }
    found.effort = search.effort();
    if (open) found.open = std::move(open->found);
    if (options.progress) options.progress(done += last - first, segments.size());
    return found;
  };
  if (segments.size() <= in_a_lot) return find_in(0, segments.size());
  const unsigned threads = segments.size() <= too_few * in_a_lot ? 1 : options.threads;
  // There are many lots, and most have few pieces: a ShortList each would take 2 KB.
  struct Lot {
    std::vector<FreePiece<Numbers>> pieces;
    OpenCandidates<Numbers> open;
    SearchEffort effort;
  };
  const auto lot_of = [&](std::size_t first, std::size_t last) {
    FoundPieces<Numbers> found = find_in(first, last);
    return Lot{{std::make_move_iterator(found.pieces.begin()),
                std::make_move_iterator(found.pieces.end())},
               std::move(found.open),
               found.effort};
  };
  FoundPieces<Numbers> all;
  for (Lot& lot : found_in_parts(segments.size(), threads, lot_of, in_a_lot)) {
    all.pieces.insert(all.pieces.end(), std::make_move_iterator(lot.pieces.begin()),
                      std::make_move_iterator(lot.pieces.end()));
    all.open.take(std::move(lot.open));
    all.effort += lot.effort;
  }
  return all;
}

}  // namespace oplus::slide
