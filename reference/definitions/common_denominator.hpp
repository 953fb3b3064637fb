// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/region.hpp"

namespace oplus {

/// Multiplies `common`, as far as it must, so that both coordinates times it are integers.
inline void add_denominators(mpz_class& common, const Point& p) {
  for (const Rational* c : {&p.x, &p.y})
    if (mpz_divisible_p(common.get_mpz_t(), c->get_den_mpz_t()) == 0)
      mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), c->get_den_mpz_t());
}

/// The same for all vertices, as long as it has no more than so many bits. Returns whether all are done.
inline bool add_denominators(mpz_class& common, const Region& region, std::size_t most_bits) {
  const auto is_short = [&] { return mpz_sizeinbase(common.get_mpz_t(), 2) <= most_bits; };
  each_vertex(region, [&](const Point& p) {
    if (is_short()) add_denominators(common, p);
  });
  return is_short();
}

}  // namespace oplus
