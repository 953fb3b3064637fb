// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "reference/families/pairs.hpp"
#include "reference/families/rich_regions.hpp"

namespace oplus {

Summands components_pair(Random& random, std::size_t n) {
  Region p = scattered_region(random, n);
  Region q;
  switch (uniform(random, 0, 3)) {
    case 0:
      q = scattered_region(random, n);
      break;
    case 1:
      q = holed_region(random, n);
      break;
    default:
      q = plain_region(random, n);
  }
  return {std::move(p), std::move(q)};
}

}  // namespace oplus
