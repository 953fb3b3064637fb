// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <boost/functional/hash.hpp>
#include <unordered_set>

#include "reference/definitions/mutant.hpp"

namespace oplus {

/// Leaves out segments that are where others before them are; the others stay in order. Only edges of equal
/// directions have such: may_have_copies(segment) says so, and place_of(segment) is the array of its source and
/// direction, in doubles that are exact.
template <typename Segments, typename MayHaveCopies, typename PlaceOf>
void leave_out_copies(Segments& segments, const MayHaveCopies& may_have_copies,
                      const PlaceOf& place_of) {
  using Place = std::array<double, 4>;
  std::unordered_set<Place, boost::hash<Place>> seen;
  const auto is_copy = [&](const auto& segment) {
    if (!may_have_copies(segment)) return false;
    Place place = place_of(segment);
    if (OPLUS_MUTANT(
            "copies-are-anywhere-on-a-line-upwards",
            "of segments with one direction that start at one x, all but one are left out"))
      place[1] = 0;
    return !seen.insert(place).second;
  };
  segments.erase(std::remove_if(segments.begin(), segments.end(), is_copy), segments.end());
}

}  // namespace oplus
