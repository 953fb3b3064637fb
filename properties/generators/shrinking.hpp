// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "properties/generators/family.hpp"

namespace oplus {

/// Returns valid pairs that are each a step smaller (see `size_of`), most promising first:
/// components, holes and vertices left out, coordinates moved to integers, towards zero, halved.
std::vector<Summands> smaller(const Summands& summands);

/// What shrinking makes less of, compared in this order; strictly less after each step, so that
/// shrinking ends.
struct Size {
  std::size_t vertices = 0;
  Rational coordinates;  ///< sum over all coordinates of |numerator| + denominator

  friend bool operator<(const Size& a, const Size& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.coordinates < b.coordinates;
  }
};
Size size_of(const Summands& summands);

/// Returns a pair that still fails and of which no smaller one does.
/// Requires: fails(summands).
Summands shrink(Summands summands, const std::function<bool(const Summands&)>& fails);

}  // namespace oplus
