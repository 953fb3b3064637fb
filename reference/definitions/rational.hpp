// SPDX-License-Identifier: MIT
#pragma once

#include "reference/definitions/values.hpp"

namespace oplus {

/// Returns -1, 0 or 1.
inline int sign(const Rational& value) { return sgn(value); }

}  // namespace oplus
