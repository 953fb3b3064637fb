// SPDX-License-Identifier: MIT
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {
constexpr std::size_t longest_quote = 40;
}

std::string one_line(std::string_view text) {
  constexpr std::string_view hexadecimal = "0123456789abcdef";
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      result += c;
    } else {
      result += "\\x";
      result += hexadecimal[byte >> 4U];
      result += hexadecimal[byte & 0xfU];
    }
  }
  return result;
}

std::string quote(std::string_view text) {
  const bool is_long = text.size() > longest_quote;
  return "'" + one_line(text.substr(0, longest_quote)) + (is_long ? "...'" : "'");
}

}  // namespace oplus
