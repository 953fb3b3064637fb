// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/message.hpp"

#include "checked/cli/command_line/terminal.hpp"

namespace oplus {

void say(const std::string& message) { say("oplus", message); }
void say_error(const std::string& message) { say_error("oplus", message); }
void say_note(const std::string& message) { say_note("oplus", message); }

}  // namespace oplus
