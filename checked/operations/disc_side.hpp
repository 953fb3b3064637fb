// SPDX-License-Identifier: MIT
#pragma once

namespace oplus {

/// On which side of a circle a polygon is.
enum class DiscSide { inside, outside };

}  // namespace oplus
