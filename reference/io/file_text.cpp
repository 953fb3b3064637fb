// SPDX-License-Identifier: MIT
#include "reference/io/file_text.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>

#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

std::string whole_text(std::istream& in, const std::string& name, const std::string& expected) {
  errno = 0;
  std::string text;
  std::array<char, 1 << 16> block{};
  do {
    in.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  } while (in);
  if (in.bad())  // a directory, for one
    throw InvalidInput(
        {name, 0, 0},
        "cannot be read" + (errno != 0 ? " (" + std::string(std::strerror(errno)) + ")" : ""),
        expected);
  return text;
}

}  // namespace

std::string input_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string input_text(const std::string& path, const std::string& expected) {
  if (path == "-") return whole_text(std::cin, input_name(path), expected);
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw InvalidInput({path, 0, 0}, std::string("cannot be opened (") + std::strerror(errno) + ")",
                       "a file that can be read");
  return whole_text(in, path, expected);
}

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
