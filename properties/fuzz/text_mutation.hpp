// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"
#include "reference/families/random.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

/// A text as the readers see it: runs of blanks, punctuation a character each, and words, numbers
/// among them. Put together again they are the text.
std::vector<std::string> tokens(std::string_view text);

/// A change that keeps most of a text, or nothing of it. `apply` returns false where there is
/// nothing to change.
struct TextChange {
  std::string name;
  bool (*apply)(Random& random, std::vector<std::string>& tokens, Format format);
};
const std::vector<TextChange>& text_changes();

/// A text like this one, after one to three changes.
std::string mutated_text(Random& random, std::string_view text, Format format);

/// A beginning of one with an end of the other.
std::string crossed_text(Random& random, std::string_view a, std::string_view b);

/// A valid region in a format, small, with holes and several components as often as not; its
/// coordinates are integers, decimals or fractions, small or large.
std::string new_region_text(Random& random, Format format);

/// The same with dangling edges and isolated vertices, where the format can hold them.
std::string new_sum_text(Random& random, Format format);

}  // namespace oplus
