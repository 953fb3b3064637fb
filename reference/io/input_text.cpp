// SPDX-License-Identifier: MIT
#include "reference/io/input_text.hpp"

#include "reference/io/quoting.hpp"

namespace oplus {

std::string describe(const Token& token) {
  return token.is_end() ? "the end of the input" : quote(token.text);
}

Tokenizer::Tokenizer(const InputText& input, std::string_view punctuation)
    : input_(input), rest_(input.text), punctuation_(punctuation) {
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
  std::size_t blanks = 0;
  for (; blanks < rest_.size() && is_blank(rest_[blanks]); ++blanks) position_.pass(rest_[blanks]);
  rest_.remove_prefix(blanks);
  if (rest_.empty()) {
    current_ = {{}, after_last};
    position_ = after_last;
    return;
  }
  const auto is_punctuation = [&](char c) {
    return punctuation_.find(c) != std::string_view::npos;
  };
  std::size_t length = 1;
  if (!is_punctuation(rest_[0])) {
    while (length < rest_.size() && !is_blank(rest_[length]) && !is_punctuation(rest_[length]))
      ++length;
  }
  current_ = {rest_.substr(0, length), position_};
  position_.column += length;
  rest_.remove_prefix(length);
  input_.passed(start, input_.text.size() - rest_.size());
}

}  // namespace oplus
