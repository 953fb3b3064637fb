// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <vector>

#include "reference/families/family.hpp"

namespace oplus {

/// Returns the valid pairs that are a step smaller (see `size_of`), most promising first:
/// components, holes and runs of vertices left out, holes made dents, then coordinates scaled to
/// integers, translated, rounded, halved, moved towards zero. A summand that has a component keeps
/// one. Requires: both summands are valid.
std::vector<Summands> smaller(const Summands& summands);

/// What shrinking makes less of, compared in this order; strictly less after each step, so that
/// shrinking ends.
struct Size {
  std::size_t vertices = 0;
  Rational coordinates;  ///< sum over all coordinates of |numerator| + denominator

  friend std::weak_ordering operator<=>(const Size&, const Size&) = default;
};
Size size_of(const Summands& summands);

/// Returns a pair that still fails and of which none of `smaller` does.
/// Requires: both summands are valid. Throws ContractViolation where not fails(summands).
Summands shrink(Summands summands, const std::function<bool(const Summands&)>& fails);

}  // namespace oplus
