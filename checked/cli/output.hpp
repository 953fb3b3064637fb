// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/io/writing.hpp"

namespace oplus {

/// Where a region or a sum is written, and how.
struct RegionOutput {
  std::string path = "-";  ///< "-" is standard output
  std::optional<Format> format;
  std::optional<int> digits;  ///< exact if empty
};

/// The format to write in: the one asked for, else by the ending of the path; WKT on standard
/// output. Throws UsageError for an ending that names no format.
Format output_format(const RegionOutput& output);

/// Writes the text of a region or a sum, which is `written` in this format with the output's digits, and
/// says what is to be known of it. Throws UsageError where it cannot write.
void write_region(const RegionOutput& output, Format format, const std::string& text);

/// Says on standard error that such a text was rounded and whether it is still valid, or that it contains
/// fractions that other programs do not read.
void say_what_was_written(const RegionOutput& output, Format format, const std::string& text);

/// Throws UsageError where an output could not be written, two would be written to one place, or a
/// picture's path does not end in .svg (in capitals or not), so that it is known before anything is
/// computed or written. "-" is standard output; it and devices may get pictures.
void require_writable(std::vector<std::string> paths,
                      const std::optional<std::string>& picture = std::nullopt);

}  // namespace oplus
