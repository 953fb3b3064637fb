// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

namespace oplus {

/// Every coordinate and every number derived from one: an exact rational in lowest terms.
using Rational = mpq_class;

/// Returns -1, 0 or 1.
inline int sign(const Rational& value) { return sgn(value); }

}  // namespace oplus
