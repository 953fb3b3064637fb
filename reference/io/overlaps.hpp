// SPDX-License-Identifier: MIT
#pragma once

namespace oplus {

/// Whether the components of an input may overlap, run along each other, or be inside each other.
enum class Overlaps {
  refused,  ///< they may touch in points, as those of a valid region
  allowed   ///< each by itself is valid, and no more is required
};

}  // namespace oplus
