// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

/// Turns a crash (a failed assertion in a library, an invalid pointer) into one line on standard
/// error and the exit code of a bug, without a core dump. Leaves signals alone that are already
/// handled, by a sanitizer for example.
void report_crashes();

}  // namespace oplus
