// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

/// From now on the first SIGINT or SIGTERM sets is_interrupted() and says on standard error that the program
/// finishes; the second ends it at once. A signal that is ignored stays ignored.
void finish_when_interrupted();

/// Whether there was such a signal. Any thread may call it.
bool is_interrupted();

}  // namespace oplus
