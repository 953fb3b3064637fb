// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/definitions/direction.hpp"

namespace oplus {

/// Integer directions in the order of their angles, the positive x-axis first, the opposite of each
/// among them: enumerations of cyclic orders choose from these.
///
/// With `lines` = k + 1, for any k directions there are k of these in the same order, even if some
/// are equal, opposite or on the x-axis: the k directions and the x-axis are on at most k + 1 lines
/// through the origin; send these, in the order of their angles in [0, π), to the first of our
/// lines. Predicates that see directions only through signs of coordinates and of skew products
/// cannot tell the two apart.
class DirectionsAround {
 public:
  /// Requires: lines >= 1.
  explicit DirectionsAround(std::size_t lines) {
    const auto count = static_cast<long>(lines);
    directions_.push_back({1, 0});
    for (long i = 1; i < count; ++i) directions_.push_back({count - 2 * i, i});
    for (std::size_t i = 0; i < lines; ++i) directions_.push_back(-directions_[i]);
  }

  std::size_t size() const { return directions_.size(); }
  const Vector& operator[](std::size_t i) const { return directions_[i]; }
  std::size_t opposite(std::size_t i) const { return (i + size() / 2) % size(); }

  /// Places are numbered counterclockwise, two to a direction: that of Q's follows that of P's, the
  /// tie rule (thesis, Definition 2.2.7) in whole numbers.
  std::size_t places() const { return 2 * size(); }
  std::size_t place(std::size_t i, Summand of) const { return 2 * i + (of == Summand::Q ? 1 : 0); }

  /// How many places counterclockwise from a to b.
  std::size_t turn(std::size_t a, std::size_t b) const { return (b + places() - a) % places(); }

 private:
  std::vector<Vector> directions_;
};

/// Calls visit with each of the count^K choices of K numbers below count.
template <std::size_t K, typename Visit>
void for_each_choice(std::size_t count, Visit visit) {
  std::array<std::size_t, K> choice{};
  for (std::size_t changed = 0; changed < K;) {
    visit(choice);
    for (changed = 0; changed < K && ++choice[changed] == count; ++changed) choice[changed] = 0;
  }
}

}  // namespace oplus
