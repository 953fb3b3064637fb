// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/along_lines/frame.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace oplus::along_lines {

Frame frame_of(const Region& p, const Region& q) {
  Frame frame{p.components.at(0).outer.at(0), q.components.at(0).outer.at(0)};
  std::vector<Rational> all;
  std::array<Rational, 2> largest = {0, 0};
  const auto add = [&](const Region& region, const Point& first, Rational& most) {
    for (const Chain& chain : chains(region))
      for (const Point& v : chain)
        for (Rational value : {Rational(v.x - first.x), Rational(v.y - first.y)}) {
          if (value == 0) continue;
          most = std::max(most, Rational(abs(value)));
          all.push_back(std::move(value));
        }
  };
  add(p, frame.first_of_p, largest[0]);
  add(q, frame.first_of_q, largest[1]);
  mpz_class denominator = 1, divisor = 0;
  for (const Rational& value : all) denominator = lcm(denominator, value.get_den());
  for (const Rational& value : all)
    divisor = gcd(divisor, mpz_class(value.get_num() * (denominator / value.get_den())));
  frame.factor = Rational(denominator, divisor);
  frame.factor.canonicalize();
  const Rational most = (largest[0] + largest[1]) * frame.factor;
  frame.bits = mpz_sizeinbase(most.get_num().get_mpz_t(), 2);
  return frame;
}

}  // namespace oplus::along_lines
