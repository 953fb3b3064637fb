// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arithmetic/filtered_direction.hpp"

#include <utility>

#include "checked/arithmetic/interval.hpp"
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
  const IntervalPoint vector = interval(exact_.vector);
  x_ = {vector.x.inf(), vector.x.sup()};
  y_ = {vector.y.inf(), vector.y.sup()};
}

std::optional<int> FilteredDirection::filtered_compare_slope(const FilteredDirection& a,
                                                             const FilteredDirection& b) {
  const auto interval_of = [](const Range& range) { return Interval(range.low, range.high); };
  const CGAL::Uncertain<CGAL::Comparison_result> slopes =
      CGAL::compare(interval_of(a.y_) * interval_of(b.x_), interval_of(a.x_) * interval_of(b.y_));
  if (!CGAL::is_certain(slopes)) return std::nullopt;
  return CGAL::get_certain(slopes);
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
