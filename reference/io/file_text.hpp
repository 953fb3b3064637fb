// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace oplus {

/// Returns all bytes of a file. Throws InvalidInput, with what was expected, where it cannot be read.
std::string text_of_file(const std::filesystem::path& file, const std::string& expected = "a file");

}  // namespace oplus
