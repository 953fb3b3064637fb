// SPDX-License-Identifier: MIT
#include "reference/io/file_text.hpp"

#include <fstream>
#include <iterator>

#include "reference/io/invalid_input.hpp"

namespace oplus {

std::string text_of_file(const std::filesystem::path& file, const std::string& expected) {
  std::ifstream in;
  in.exceptions(std::ios::badbit | std::ios::failbit);
  try {
    in.open(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  } catch (const std::ios_base::failure&) {
    throw InvalidInput({file.string(), 1, 0}, "cannot be read", expected);
  }
}

}  // namespace oplus
