// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "reference/families/pairs.hpp"
#include "reference/families/rich_regions.hpp"

namespace oplus {

Summands holes_pair(Random& random, std::size_t n) {
  Region p = holed_region(random, n);
  Region q = one_in(random, 2) ? holed_region(random, n) : plain_region(random, n);
  return {std::move(p), std::move(q)};
}

}  // namespace oplus
