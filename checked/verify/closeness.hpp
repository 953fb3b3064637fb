// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checked/collision/segment_tree.hpp"
#include "reference/definitions/claimed_sum.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// The largest distance of a point of a boundary from another one.
struct BoundaryDistance {
  /// Certified bounds of its square, equal where it is known exactly; else the upper one is larger
  /// by at most a 2^20th.
  Rational least_squared;
  Rational most_squared;
  /// A point of one boundary that is farther from the other than the square root of `least_squared`
  /// or as far.
  Point farthest;
  bool farthest_is_given;  ///< whether it is one of the given boundary
};

/// How far a given sum is from the right one.
struct Closeness {
  /// The Hausdorff distance of the boundaries; empty where one of the two sums is empty and the other is not. Where it is
  /// more than D, but the sets differ near the boundary only, that of the given boundary from the right one, which
  /// is not: of a part that is lost, the right boundary may be as far away as it is long.
  std::optional<BoundaryDistance> distance;
  bool is_within;  ///< decided exactly: whether the Hausdorff distance is at most D
  std::vector<std::string> no_partners;  ///< a line for each chain without a partner
  bool
      differs_near_boundary_only;  ///< near_boundary.hpp; not asked where the others say that it is close
  std::vector<std::string> notes;  ///< chains that cross or overlap, as rounding makes them

  /// Whether boundaries and chains correspond; or, where parts thinner than D are lost, or joined, what is left
  /// does.
  bool is_close() const { return has_same_chains() || differs_near_boundary_only; }
  bool has_same_chains() const { return is_within && no_partners.empty(); }
  /// Whether `distance` is that of the given boundary only.
  bool is_distance_of_given() const { return !is_within && differs_near_boundary_only; }
};

/// Compares boundaries: all chains as they are given, with dangling edges and isolated vertices. A
/// chain and one of the right sum are partners if their Hausdorff distance is at most D; chains are
/// those of region_of(right) and of the set the given sum stands for. Components correspond where
/// outer chains can be paired with partners one to one, and holes likewise. Requires: D >= 0.
Closeness closeness(const PlanarSet& right, const ClaimedSum& sum, const Rational& tolerance);

/// Whether each point of `from` is at most as far from `to` as the square root of `squared`; decided
/// exactly. A segment may be a point.
bool is_within(const std::vector<Segment>& from, const SegmentTree& to, const Rational& squared);

/// The Hausdorff distance. Requires: neither is empty.
BoundaryDistance distance(const std::vector<Segment>& right, const std::vector<Segment>& given);

/// The largest distance of a point of `given` from `right`. Requires: neither is empty.
BoundaryDistance distance_of_given(const std::vector<Segment>& right,
                                   const std::vector<Segment>& given);

}  // namespace oplus
