// SPDX-License-Identifier: MIT
#include "checked/arithmetic/filtered_direction.hpp"

#include <utility>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

int sector(const Vector& v) {
  constexpr int by_signs[3][3] = {{5, 6, 7}, {4, -1, 0}, {3, 2, 1}};
  return by_signs[sign(v.y) + 1][sign(v.x) + 1];
}

}  // namespace

FilteredDirection::FilteredDirection(Direction exact)
    : exact_(std::move(exact)), sector_(sector(exact_.vector)) {
  OPLUS_REQUIRES(sector_ >= 0, "Definition 2.1.7");
  x_ = interval(exact_.vector.x);
  y_ = interval(exact_.vector.y);
}

std::optional<int> FilteredDirection::filtered_compare_slope(const FilteredDirection& a,
                                                             const FilteredDirection& b) {
  if (is_exact(a.x_) && is_exact(a.y_) && is_exact(b.x_) && is_exact(b.y_)) {
    const std::optional<int> rounded = sign_of_difference(a.y_.low * b.x_.low, a.x_.low * b.y_.low);
    if (rounded) return rounded;
  }
  return compare(a.y_ * b.x_, a.x_ * b.y_);
}

int FilteredDirection::compare_equal(Summand a, Summand b) {
  static const int p_and_q = compare(Direction{{1, 0}, Summand::P}, Direction{{1, 0}, Summand::Q});
  if (a == b) return 0;
  if (OPLUS_MUTANT("filtered-ties-the-other-way",
                   "where the filter sees that directions are equal, P's comes after Q's"))
    return a == Summand::P ? -p_and_q : p_and_q;
  return a == Summand::P ? p_and_q : -p_and_q;
}

}  // namespace oplus
