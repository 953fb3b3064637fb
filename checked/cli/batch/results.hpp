// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace oplus {

/// Some results, a line of JSON each, and what is to be said of them at the end.
struct Results {
  std::string lines;
  std::size_t share = 0;  ///< how much of the input it was, in bytes or pairs
  std::size_t pairs = 0;  ///< errors too
  std::size_t errors = 0;
  std::size_t bugs = 0;      ///< errors that are not the input's
  std::string first_error;   ///< empty if there is none
  std::size_t repaired = 0;  ///< inputs of which reading had something to note
  std::string first_note;

  /// Adds the counts of others, which come after these, and nothing to the lines.
  void count(const Results& others) {
    pairs += others.pairs;
    errors += others.errors;
    bugs += others.bugs;
    repaired += others.repaired;
    if (first_error.empty()) first_error = others.first_error;
    if (first_note.empty()) first_note = others.first_note;
  }

  /// Notes what reading said of a line of a file.
  void note(const std::string& file, std::size_t line, const std::vector<std::string>& notes) {
    if (notes.empty()) return;
    ++repaired;
    if (first_note.empty()) first_note = file + ":" + std::to_string(line) + ": " + notes.front();
  }
};

}  // namespace oplus
