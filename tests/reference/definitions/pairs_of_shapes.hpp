// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "tests/reference/definitions/shapes.hpp"

namespace oplus {

/// Calls `check(p, q)` for every two of the `shapes()`; what fails in it is told with their names.
template <typename Check>
void for_each_pair_of_shapes(Check check) {
  for (const Shape& p : shapes()) {
    for (const Shape& q : shapes()) {
      SCOPED_TRACE(p.name + " and " + q.name);
      check(p.region, q.region);
    }
  }
}

}  // namespace oplus
