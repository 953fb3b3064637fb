// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/engine.hpp"

namespace oplus {

/// The algorithms under check, the default first. The table of the program `oplus` has the oracle
/// besides (checked/cli/shared_options.hpp).
const std::vector<Engine>& engines();

}  // namespace oplus
