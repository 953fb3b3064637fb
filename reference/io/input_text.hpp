// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "reference/io/invalid_input.hpp"

namespace oplus {

/// A place in a text, both from one; columns count bytes.
struct Position {
  std::size_t line = 1;
  std::size_t column = 1;

  /// Moves past a character.
  void pass(char c) {
    if (c == '\n')
      *this = {line + 1, 1};
    else
      ++column;
  }

  friend auto operator<=>(const Position&, const Position&) = default;
};

/// A whole input and what messages call it. The text must outlive it.
struct InputText {
  std::string name;
  std::string_view text = {};
  std::function<void(int percent)> progress = {};  ///< as in reading.hpp

  /// Reports progress, once per megabyte. Requires: the bytes from `from` to `to` were just read.
  void passed(std::size_t from, std::size_t to) const {
    constexpr unsigned bits_of_a_megabyte = 20;
    if (progress && from >> bits_of_a_megabyte != to >> bits_of_a_megabyte)
      progress(static_cast<int>(std::min<std::size_t>(99, 100 * to / text.size())));
  }

  /// Throws InvalidInput.
  [[noreturn]] void refuse(const Position& at, const std::string& wrong,
                           const std::string& expected) const {
    throw InvalidInput({name, at.line, at.column}, wrong, expected);
  }
};

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// What follows a byte order mark, or all of the text.
inline std::string_view without_byte_order_mark(std::string_view text) {
  return text.substr(text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
}

inline constexpr std::string_view blanks = " \t\n\r\v\f";

inline bool is_blank(char c) { return c == ' ' || ('\t' <= c && c <= '\r'); }

struct Token {
  std::string_view text;  ///< empty at the end of the input
  Position at;            ///< of its first character; the end is just after the last token

  bool is_end() const { return text.empty(); }
};

/// Returns the token for a message: quoted, or "the end of the input".
std::string describe(const Token& token);

/// Words between blanks, and the characters of `punctuation`, each a token of its own.
/// The input must outlive it.
class Tokenizer {
 public:
  Tokenizer(const InputText& input, std::string_view punctuation);

  const Token& peek() const { return current_; }
  Token take();

  /// Whether the next token is the first one of its line.
  bool is_first_of_line() const { return is_first_of_line_; }

  /// What follows the next token.
  std::string_view rest() const { return rest_; }

 private:
  void advance();

  bool ends_word(char c) const { return ends_word_[static_cast<unsigned char>(c)]; }

  const InputText& input_;
  std::string_view rest_;
  std::array<bool, 256> ends_word_{};  ///< of each byte: blanks and punctuation
  Position position_;
  Token current_;
  bool is_first_of_line_ = true;
};

}  // namespace oplus
