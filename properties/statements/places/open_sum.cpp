// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/places/open_sum.hpp"

#include "reference/definitions/collision.hpp"

namespace oplus {

OpenSum::OpenSum(const Summands& summands) : p_(summands.p), reflected_q_(reflected(summands.q)) {}

bool OpenSum::contains(const Point& x) {
  const auto known = known_.find(x);
  if (known != known_.end()) return known->second;
  return known_[x] = interiors_meet(p_, translated(reflected_q_, x));
}

}  // namespace oplus
