// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/cli/subcommands.hpp"

namespace oplus {

/// Does the action. Returns its exit code, or that of what it throws, after saying in one line on
/// standard error what that was.
int exit_code_of(const Action& action) noexcept;

}  // namespace oplus
