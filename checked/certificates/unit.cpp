// SPDX-License-Identifier: MIT
#include "checked/certificates/unit.hpp"

#include <algorithm>

#include "reference/definitions/region.hpp"

namespace oplus::certificates {

pieces::ConvexPieces pieces_of_summand(const Region& region) {
  constexpr std::uint32_t most_corners = 8;
  return pieces::convex_pieces(region, most_corners);
}

mpz_class unit(const std::vector<const Region*>& regions, const pieces::ShiftedDoubles& doubles) {
  constexpr std::size_t most_bits = 64;
  mpz_class common = 1;
  for (const Region* region : regions)
    for (const Chain& chain : chains(*region))
      for (const Point& v : chain)
        for (const Rational* x : {&v.x, &v.y}) {
          if (x->get_den() == 1) continue;
          common = lcm(common, x->get_den());
          if (mpz_sizeinbase(common.get_mpz_t(), 2) > most_bits)
            return mpz_class(1) << static_cast<unsigned long>(std::max(0L, 53 - doubles.bits()));
        }
  return common;
}

}  // namespace oplus::certificates
