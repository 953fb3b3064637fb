// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/integer_scale.hpp"

#include <algorithm>

namespace oplus {

namespace {

template <typename Visit>
void for_each_coordinate(const Region& region, Visit visit) {
  for (const Chain& chain : chains(region)) {
    for (const Point& p : chain) {
      visit(p.x);
      visit(p.y);
    }
  }
}

Rational largest(const Region& region) {
  Rational result = 0;
  for_each_coordinate(region,
                      [&](const Rational& c) { result = std::max(result, Rational(abs(c))); });
  return result;
}

}  // namespace

IntegerScale IntegerScale::of(const Summands& pair, const mpz_class& most) {
  mpz_class denominator = 1;
  for (const Region* region : {&pair.p, &pair.q})
    for_each_coordinate(*region,
                        [&](const Rational& c) { denominator = lcm(denominator, c.get_den()); });
  const Rational reach = largest(pair.p) + largest(pair.q);
  Rational factor = denominator;
  if (factor * reach > most) throw NotTaken("its integers are too small");
  while (reach > 0 && 2 * factor * reach <= most) factor *= 2;
  return {factor};
}

long IntegerScale::scaled(const Rational& value) const {
  return Rational(value * factor).get_num().get_si();
}

}  // namespace oplus
