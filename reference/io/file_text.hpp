// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace oplus {

/// Returns all bytes of a file. Throws InvalidInput, with what was expected, where it cannot be read.
std::string text_of_file(const std::filesystem::path& file, const std::string& expected = "a file");

/// The same of what a command is given, where "-" is standard input; and what messages call it.
std::string input_text(const std::string& path, const std::string& expected);
std::string input_name(const std::string& path);

}  // namespace oplus
