// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace oplus {

/// Writes "oplus: message" to standard error, as one line whatever the message contains.
void say(const std::string& message);

}  // namespace oplus
