// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "reference/families/family.hpp"

namespace oplus {

/// A fork with `teeth` teeth on each of its two arms, 8n + 4 vertices, and a long thin L: their sum
/// has exactly n² holes (thesis, Section 6.1.4). Requires: teeth >= 1.
Summands fork_and_l(std::size_t teeth);

}  // namespace oplus
