// SPDX-License-Identifier: GPL-3.0-or-later

#include <iterator>
#include <utility>

#include "reference/families/pairs.hpp"
#include "reference/io/power_of_ten.hpp"

namespace oplus {

Summands diamond_and_u(const Rational& eps1, const Rational& eps2) {
  const Rational half(1, 2);
  Chain diamond{{-eps2, 0}, {half, -half}, {1, 0}, {half, half}};
  Chain u{{0, 0}, {7, 0}, {7, 6}, {4, 6}, {4, 5},        {6, 5},
          {6, 1}, {1, 1}, {1, 5}, {3, 5}, {3 - eps1, 6}, {0, 6}};
  return {polygon(std::move(u)), polygon(std::move(diamond))};
}

Summands diamond_and_u_pair(Random& random, std::size_t) {
  const int size = uniform(random, 0, 2);
  if (size == 0) return diamond_and_u(0, 0);
  const unsigned exponent =
      static_cast<unsigned>(size == 1 ? uniform(random, 9, 15) : uniform(random, 1, 3));
  const Rational eps1 = Rational(uniform(random, 2, 9)) / power_of_ten(exponent);
  // The thesis has 0 < eps2 < eps1; none, equal and larger ones are the cases next to it.
  const Rational share[] = {Rational(0),     Rational(1, 3), Rational(1, 2),
                            Rational(9, 10), Rational(1),    Rational(3, 2)};
  const Rational eps2 = share[uniform_index(random, std::size(share))] * eps1;
  return diamond_and_u(eps1, eps2);
}

}  // namespace oplus
