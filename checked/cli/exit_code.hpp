// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

/// What the program's exit code says.
enum class ExitCode {
  done = 0,       ///< of `compare`: equal; of `verify`: yes
  not_equal = 1,  ///< of `compare` and `verify` only
  invalid = 2,    ///< invalid input or usage, or a file that cannot be read or written
  bug = 3,        ///< in oplus
};

}  // namespace oplus
