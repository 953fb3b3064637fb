// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "checked/slide/for_each_number.hpp"
#include "checked/slide/low_dimensional_features.hpp"
#include "checked/slide/named_ends.hpp"
#include "checked/slide/unblocked_places.hpp"

namespace oplus::slide {

/// What may be in the boundary of the open sum but not of the closed one: on the segments, where the
/// closed sum is to their right as well. `pieces` are the free ones.
template <typename Numbers>
Candidates low_dimensional_candidates(const Tracks<Numbers>& tracks,
                                      const ShortList<FreePiece<Numbers>>& pieces,
                                      const Scaling& scaling, unsigned threads) {
  std::vector<std::vector<Piece<Numbers>>> free(tracks.size());
  for (const FreePiece<Numbers>& piece : pieces) free[piece.segment].push_back(piece.piece);
  std::vector<Candidates> of_segments(tracks.size());
  for_each_number(tracks.size(), threads, [&](std::size_t number) {
    const auto i = static_cast<std::uint32_t>(number);
    const Track<Numbers> track = tracks[i];
    const auto is_free = [&](const Fraction<Numbers>& from, const Fraction<Numbers>& to) {
      return std::any_of(free[i].begin(), free[i].end(), [&](const Piece<Numbers>& piece) {
        return !(from < piece.from) && !(piece.to < to);
      });
    };
    const auto point = [&](const Fraction<Numbers>& t) {
      return ExactPoint<Numbers>(track.exact, t).in_the_plane(scaling);
    };
    UnblockedPlaces<Numbers> search(tracks.summands());
    search.find(track, [&](const std::vector<Fraction<Numbers>>& places) {
      for (std::size_t k = 0; k < places.size(); ++k) {
        if (!is_free(places[k], places[k])) of_segments[i].points.push_back(point(places[k]));
        if (k == 0 || is_free(places[k - 1], places[k])) continue;
        of_segments[i].pieces.push_back(
            {{point(places[k - 1]), point(places[k])},
             point(place_inside(Piece<Numbers>{places[k - 1], places[k]}))});
      }
    });
  });
  Candidates all;
  for (Candidates& of_segment : of_segments) all.take(std::move(of_segment));
  return all;
}

}  // namespace oplus::slide
