// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "properties/runner/mixture.hpp"
#include "reference/definitions/intersection_components.hpp"
#include "reference/definitions/region.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// A point in which chains of a region touch.
struct TouchingExteriors {
  Point at;
  int exteriors;  ///< at least 1
};

/// Returns the points in which chains of a valid region touch, and into how many parts the exterior
/// around each is divided: two where a hole touches its outer chain, one where two components
/// touch.
std::vector<TouchingExteriors> touching_exteriors(const Region& region);

/// The intersection of P and -Q+x, as Section 4.2.4 has to count it.
struct CountedIntersection {
  ComponentsAndHoles of_interiors;
  /// Points inside the other summand in which chains of one summand divide its exterior: a hole
  /// touches the outside there, and the interiors look the same as without that hole.
  int parted_exteriors;

  /// Of the intersection with touching chains moved apart a little, none of them cut.
  int euler_characteristic() const {
    return of_interiors.euler_characteristic() - parted_exteriors;
  }
};

std::string in_words(const CountedIntersection& counted);

/// Counts intersections of one pair.
class IntersectionCounter {
 public:
  explicit IntersectionCounter(const Summands& summands);

  /// Requires: x is on no segment of the vertex-edge sum.
  CountedIntersection at(const Point& x) const;

 private:
  Region p_;
  Region q_;
  std::vector<TouchingExteriors> touching_in_p_;
  std::vector<TouchingExteriors> touching_in_q_;
};

/// What is wrong with the intersection at a placement, in words, or empty; may count what it saw.
using AtPlacement = std::function<std::string(const Point& x, const CountedIntersection& counted,
                                              Outcome& outcome)>;

/// Tests all generic placements of a pair with the function that `of_pair` returns for it, and
/// counts the kinds of intersections. If only one summand has holes, also tests the pair with the
/// other summand four times as large: it covers holes, so that intersections have holes.
Outcome at_generic_placements(const Summands& summands,
                              const std::function<AtPlacement(const Summands& pair)>& of_pair);

/// Pairs for statements about these intersections: many have holes that touch nothing.
Mixture pairs_with_holes();

}  // namespace oplus
