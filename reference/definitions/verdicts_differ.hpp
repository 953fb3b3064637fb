// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace oplus {

/// Verdicts on whether a point is in the sum differ, by winding number, by collision, by tangents:
/// Theorem 4.2.1 is false, or one of the definitions is wrong. Never seen on a valid region.
class VerdictsDiffer : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace oplus
