// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

/// Turns what would kill the program (a broken assertion in a library, a wild pointer) into one
/// line on standard error and the exit code of a bug, without a core dump. Leaves signals alone
/// that somebody else, such as a sanitizer, handles already.
void report_crashes();

}  // namespace oplus
