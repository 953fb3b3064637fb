// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/definitions/planar_set.hpp"
#include "reference/families/random.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

/// A change that libFuzzer does not make from bytes and dictionaries: of a number as a whole. `apply`
/// returns false where nothing could be changed.
struct TextChange {
  std::string name;
  bool (*apply)(Random& random, std::string& text, Format format);
};
const std::vector<TextChange>& text_changes();

/// This text after one to three changes; in a quarter of the calls, and always for a text without
/// numbers, a new text.
std::string mutated_text(Random& random, std::string_view text, Format format);

/// A valid region in a format, small, with holes and several components as often as not; its
/// coordinates are integers, decimals or fractions, small or large.
std::string new_region_text(Random& random, Format format);

/// The same with dangling edges and isolated vertices, where the format can hold them.
std::string new_sum_text(Random& random, Format format);

}  // namespace oplus
