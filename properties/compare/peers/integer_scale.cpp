// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/integer_scale.hpp"

#include <algorithm>

namespace oplus {

IntegerScale IntegerScale::of(const Summands& pair, const mpz_class& most) {
  mpz_class denominator = 1;
  Rational reach = 0;
  for (const Region* region : {&pair.p, &pair.q}) {
    Rational largest = 0;
    for (const Segment& edge : edges(*region)) {
      for (const Rational& c : {edge.source.x, edge.source.y}) {
        denominator = lcm(denominator, c.get_den());
        largest = std::max(largest, Rational(abs(c)));
      }
    }
    reach += largest;
  }
  Rational factor = denominator;
  if (factor * reach > most) throw Unsupported("does not support such large coordinates");
  while (reach > 0 && 2 * factor * reach <= most) factor *= 2;
  return {factor};
}

long IntegerScale::scaled(const Rational& value) const {
  return Rational(value * factor).get_num().get_si();
}

}  // namespace oplus
