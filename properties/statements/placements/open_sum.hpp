// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "reference/definitions/collision.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// The sum of the open regions by its definition, point by point and without any convolution: x is
/// in it iff the interiors of P and -Q+x meet.
class OpenSum {
 public:
  explicit OpenSum(const Summands& summands)
      : p_(summands.p), reflected_q_(reflected(summands.q)) {}

  bool contains(const Point& x) {
    const auto known = known_.find(x);
    if (known != known_.end()) return known->second;
    return known_[x] = interiors_meet(p_, translated(reflected_q_, x));
  }

 private:
  Region p_;
  Region reflected_q_;
  std::map<Point, bool> known_;
};

}  // namespace oplus
