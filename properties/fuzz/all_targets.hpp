// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "properties/fuzz/fuzz_target.hpp"

namespace oplus {

/// All targets, in the order in which they are listed.
const std::vector<FuzzTarget>& fuzz_targets();

/// Returns nullptr for an unknown name.
const FuzzTarget* find_fuzz_target(const std::string& name);

}  // namespace oplus
