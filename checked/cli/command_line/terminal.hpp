// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>

namespace oplus {

enum class ColourUse { automatic, always, never };

/// How the program speaks, the same for all of it: its name, --quiet and --color.
struct Speech {
  std::string program = "oplus";
  bool quiet = false;
  ColourUse colours = ColourUse::automatic;
};
Speech& speech();

enum class Paint { good, bad };

/// Returns the text in green or red where the stream shows colours: of itself only where it is a
/// standard stream on a terminal, and neither NO_COLOR (https://no-color.org) nor TERM=dumb forbids
/// it. Elsewhere it returns the text.
std::string painted(Paint paint, const std::string& text, const std::ostream& where);

/// Standard output; nowhere, where the answer is JSON and text would spoil it.
std::ostream& text_output(bool in_json);

/// The text with its last line, the verdict, in colour.
std::string with_painted_verdict(const std::string& text, Paint paint, const std::ostream& where);

/// Writes "program: message" to standard error, as one line whatever the message contains.
void say(const std::string& message);

/// The same for what went wrong, with colour; and for what one can do without, unless --quiet.
void say_error(const std::string& message);
void say_note(const std::string& message);

}  // namespace oplus
