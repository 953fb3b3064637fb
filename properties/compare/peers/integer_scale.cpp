// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/integer_scale.hpp"

#include <algorithm>

#include "reference/definitions/common_denominator.hpp"

namespace oplus {

IntegerScale IntegerScale::least(const std::vector<Region>& regions) {
  mpz_class denominator = 1;
  for (const Region& region : regions)
    each_vertex(region, [&](const Point& v) { add_denominators(denominator, v); });
  return {denominator};
}

IntegerScale IntegerScale::of(const std::vector<Region>& regions, const mpz_class& most,
                              const mpz_class& limit) {
  Rational first = 0, second = 0;  // the largest of two regions
  for (const Region& region : regions) {
    Rational largest = 0;
    each_vertex(region, [&](const Point& v) {
      largest = std::max({largest, Rational(abs(v.x)), Rational(abs(v.y))});
    });
    second = std::max(second, std::min(first, largest));
    first = std::max(first, largest);
  }
  const Rational reach = first + second;
  auto [factor] = least(regions);
  if (factor * reach > limit) throw Unsupported("does not support such large coordinates");
  while (reach > 0 && 2 * factor * reach <= most) factor *= 2;
  return {factor};
}

long IntegerScale::scaled(const Rational& value) const {
  return Rational(value * factor).get_num().get_si();
}

}  // namespace oplus
