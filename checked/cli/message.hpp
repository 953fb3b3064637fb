// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace oplus {

/// Writes "oplus: message" to standard error, as one line whatever the message contains.
void say(const std::string& message);

/// The same for what went wrong, and for what one can do without (--quiet).
void say_error(const std::string& message);
void say_note(const std::string& message);

}  // namespace oplus
