// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

/// The program `oplus`. Returns its exit code (exit_code.hpp); writes what went wrong to standard
/// error, in one line. Throws nothing.
int run(int argc, const char* const* argv) noexcept;

}  // namespace oplus
