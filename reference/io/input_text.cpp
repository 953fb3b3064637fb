// SPDX-License-Identifier: MIT
#include "reference/io/input_text.hpp"

#include "reference/io/quoting.hpp"

namespace oplus {

std::string describe(const Token& token) {
  return token.is_end() ? "the end of the input" : quote(token.text);
}

Tokenizer::Tokenizer(const InputText& input, std::string_view punctuation)
    : input_(input), rest_(input.text) {
  for (const char c : blanks) ends_word_[static_cast<unsigned char>(c)] = true;
  for (const char c : punctuation) ends_word_[static_cast<unsigned char>(c)] = true;
  advance();
}

Token Tokenizer::take() {
  const Token taken = current_;
  advance();
  return taken;
}

void Tokenizer::advance() {
  const std::size_t start = input_.text.size() - rest_.size();
  const Position after_last = position_;
  std::size_t skipped = 0;
  for (; skipped < rest_.size() && is_blank(rest_[skipped]); ++skipped)
    position_.pass(rest_[skipped]);
  is_first_of_line_ = start == 0 || position_.line != after_last.line;
  rest_.remove_prefix(skipped);
  if (rest_.empty()) {
    current_ = {{}, after_last};
    position_ = after_last;
    return;
  }
  std::size_t length = 1;
  if (!ends_word(rest_[0]))
    while (length < rest_.size() && !ends_word(rest_[length])) ++length;
  current_ = {rest_.substr(0, length), position_};
  position_.column += length;
  rest_.remove_prefix(length);
  input_.passed(start, input_.text.size() - rest_.size());
}

}  // namespace oplus
