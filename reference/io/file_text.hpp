// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace oplus {

/// All bytes of a file. Throws InvalidInput where it cannot be read, which says what was expected there.
std::string text_of_file(const std::filesystem::path& file, const std::string& expected = "a file");

}  // namespace oplus
