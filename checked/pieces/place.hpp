// SPDX-License-Identifier: MIT
#pragma once

namespace oplus::pieces {

/// A point in doubles.
struct Place {
  double x = 0;
  double y = 0;
};

}  // namespace oplus::pieces
