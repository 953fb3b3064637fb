// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>

namespace oplus {

enum class ColourUse { automatic, always, never };

/// How the program writes messages: its name, --quiet and --color.
struct Speech {
  std::string program = "oplus";
  bool quiet = false;
  ColourUse colours = ColourUse::automatic;
};
Speech& speech();

enum class Paint { good, bad };

/// Returns the text in green or red where the stream shows colours: by default only a standard stream
/// on a terminal, unless NO_COLOR (https://no-color.org) or TERM=dumb forbids it. Otherwise returns the
/// text.
std::string painted(Paint paint, const std::string& text, const std::ostream& where);

/// Standard output, or a stream that writes nothing if the answer is JSON.
std::ostream& text_output(bool in_json);

/// The text with its last line, the verdict, in colour.
std::string with_painted_verdict(const std::string& text, Paint paint, const std::ostream& where);

/// Writes "program: message" to standard error, as one line whatever the message contains.
void say(const std::string& message);

/// The same for errors, in colour; and for notes, unless --quiet.
void say_error(const std::string& message);
void say_note(const std::string& message);

/// Shows a line on a terminal, on standard error, until the next call, or until anything is said. May be called on
/// any thread.
void show_passing_line(const std::string& text);
void erase_passing_line();

}  // namespace oplus
