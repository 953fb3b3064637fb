// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/engine.hpp"

namespace oplus {

/// What the program offers, the default first: the engines (checked/engines/engines.hpp), then the oracle.
const std::vector<Engine>& engines_and_oracle();

}  // namespace oplus
