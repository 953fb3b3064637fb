// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/direction.hpp"

namespace oplus {

/// A direction made ready for many comparisons: first by its quadrant, exactly, then by a certified
/// interval around its vector, then by the vector itself.
class FilteredDirection {
 public:
  /// Requires: the vector is not zero.
  explicit FilteredDirection(Direction exact);

  const Direction& exact() const { return exact_; }

  /// compare_angle, empty where intervals cannot tell. Always tells where the coordinates are
  /// integers below 2^26, or the directions have different quadrants, or are both along one axis.
  friend std::optional<int> filtered_compare_angle(const FilteredDirection& a,
                                                   const FilteredDirection& b) {
    if (a.sector_ != b.sector_) return a.sector_ - b.sector_;
    return a.sector_ % 2 == 0 ? 0 : filtered_compare_slope(a, b);
  }

  /// The same as for exact directions, by their tie rule.
  friend int compare(const FilteredDirection& a, const FilteredDirection& b) {
    const std::optional<int> angles = filtered_compare_angle(a, b);
    if (!angles) return compare(a.exact_, b.exact_);
    return *angles != 0 ? *angles : compare_equal(a.exact_.of, b.exact_.of);
  }

 private:
  static std::optional<int> filtered_compare_slope(const FilteredDirection& a,
                                                   const FilteredDirection& b);

  /// compare, of equal directions of these summands.
  static int compare_equal(Summand a, Summand b);

  Direction exact_;
  Interval x_;
  Interval y_;
  int sector_;  ///< 0, 2, 4, 6: along an axis; 1, 3, 5, 7: in the quadrant between
};

}  // namespace oplus
