// SPDX-License-Identifier: MIT
#include "checked/certificates/unit.hpp"

#include <algorithm>

#include "reference/definitions/common_denominator.hpp"

namespace oplus::certificates {

pieces::ConvexPieces pieces_of_summand(const Region& region) {
  constexpr std::uint32_t most_corners = 8;
  return pieces::convex_pieces(region, most_corners);
}

mpz_class unit(const std::vector<const Region*>& regions, const pieces::ShiftedDoubles& doubles) {
  constexpr std::size_t most_bits = 64;
  mpz_class common = 1;
  for (const Region* region : regions)
    if (!add_denominators(common, *region, most_bits))
      return mpz_class(1) << static_cast<unsigned long>(std::max(0L, 53 - doubles.bits()));
  return common;
}

}  // namespace oplus::certificates
