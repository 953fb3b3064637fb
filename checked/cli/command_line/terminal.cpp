// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <string_view>

namespace oplus {

namespace {

bool is_terminal(const std::ostream& where) {
  if (&where == &std::cout) return isatty(STDOUT_FILENO) != 0;
  if (&where == &std::cerr) return isatty(STDERR_FILENO) != 0;
  return false;
}

bool forbidden_by_environment() {
  const char* const no_color = std::getenv("NO_COLOR");
  const char* const term = std::getenv("TERM");
  return (no_color != nullptr && *no_color != '\0') ||
         (term != nullptr && std::string_view(term) == "dumb");
}

bool shows_colours(const std::ostream& where) {
  if (speech().colours != ColourUse::automatic) return speech().colours == ColourUse::always;
  return is_terminal(where) && !forbidden_by_environment();
}

/// The line that passes, if there is one.
struct PassingLine {
  std::mutex mutex;
  bool is_shown = false;

  void erase() {
    if (is_shown) std::cerr << "\r\033[K" << std::flush;
    is_shown = false;
  }
};

PassingLine& passing_line() {
  static PassingLine of_the_program;
  return of_the_program;
}

void write_line(const std::string& prefix, std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  const std::lock_guard lock(passing_line().mutex);
  passing_line().erase();
  std::cerr << prefix + " " + message + "\n" << std::flush;
}

}  // namespace

Speech& speech() {
  static Speech of_the_program;
  return of_the_program;
}

std::string painted(Paint paint, const std::string& text, const std::ostream& where) {
  if (!shows_colours(where)) return text;
  return (paint == Paint::good ? "\033[32m" : "\033[31m") + text + "\033[0m";
}

std::ostream& text_output(bool in_json) {
  static std::ostream nowhere(nullptr);
  return in_json ? nowhere : std::cout;
}

std::string with_painted_verdict(const std::string& text, Paint paint, const std::ostream& where) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return text;
  const std::size_t newline = text.rfind('\n', end);
  const std::size_t start = newline == std::string::npos ? 0 : newline + 1;
  return text.substr(0, start) + painted(paint, text.substr(start, end + 1 - start), where) +
         text.substr(end + 1);
}

void say(const std::string& message) { write_line(speech().program + ":", message); }

void say_error(const std::string& message) {
  write_line(painted(Paint::bad, speech().program + ":", std::cerr), message);
}

void say_note(const std::string& message) {
  if (!speech().quiet) say(message);
}

void show_passing_line(const std::string& text) {
  const std::lock_guard lock(passing_line().mutex);
  std::cerr << "\r" + text + "\033[K" << std::flush;
  passing_line().is_shown = true;
}

void erase_passing_line() {
  const std::lock_guard lock(passing_line().mutex);
  passing_line().erase();
}

}  // namespace oplus
