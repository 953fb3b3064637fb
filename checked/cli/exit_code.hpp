// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

/// The program's exit codes.
enum class ExitCode {
  done =
      0,  ///< of `compare`: equal; of `verify` and `certify`: it is the sum; of `layout`: it is right
  not_equal = 1,  ///< of `compare`, `verify`, `certify` and `layout` only
  invalid = 2,    ///< invalid input or usage, or a file that cannot be read or written
  bug = 3,        ///< in oplus
};

}  // namespace oplus
