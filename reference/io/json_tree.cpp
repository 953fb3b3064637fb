// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/json_tree.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "reference/io/number.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

/// The parser converts each number even where only its text is wanted, and refuses one that
/// overflows; a long double overflows last.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, long double>;

/// Where the tokens start that the parser has taken. The parser takes at most one character more
/// than the token it reports, and only after a number or a literal.
class TokenPlaces {
 public:
  explicit TokenPlaces(const std::string& text) : text_(text) {}

  void pass(char c) {
    last_ = position_;
    if (in_string_) {
      in_string_ = escaped_ || c != '"';
      escaped_ = !escaped_ && c == '\\';
    } else {
      const bool in_word = in_word_;
      in_word_ = false;
      if (c == '"') {
        in_string_ = true;
        string_ = position_;
      } else if (c == '[' || c == '{') {
        bracket_ = position_;
      } else if (!is_blank(c) && c != ']' && c != '}' && c != ',' && c != ':') {
        in_word_ = true;
        if (!in_word) {
          word_ = position_;
          word_offset_ = offset_;
        }
      }
    }
    ++offset_;
    position_.pass(c);
  }

  const Position& string() const { return string_; }
  const Position& bracket() const { return bracket_; }
  const Position& word() const { return word_; }
  const Position& last() const { return last_; }
  const Position& next() const { return position_; }

  /// The text of the last number or literal.
  std::string_view word_text() const {
    const std::string_view from = std::string_view(text_).substr(word_offset_);
    const auto end = std::find_if(from.begin(), from.end(), [](char c) {
      return is_blank(c) || std::string_view("[]{},:\"").find(c) != std::string_view::npos;
    });
    return from.substr(0, static_cast<std::size_t>(end - from.begin()));
  }

 private:
  const std::string& text_;
  Position position_, last_, string_, bracket_, word_;
  std::size_t offset_ = 0, word_offset_ = 0;
  bool in_string_ = false, escaped_ = false, in_word_ = false;
};

/// Reads characters and tells the places.
class WatchedCharacter {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  WatchedCharacter(const char* at, TokenPlaces* places) : at_(at), places_(places) {}
  reference operator*() const { return *at_; }
  WatchedCharacter& operator++() {
    places_->pass(*at_);
    ++at_;
    return *this;
  }
  WatchedCharacter operator++(int) {
    const WatchedCharacter before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const WatchedCharacter& a, const WatchedCharacter& b) {
    return a.at_ == b.at_;
  }

 private:
  const char* at_;
  TokenPlaces* places_;
};

/// Builds the tree from the parser's events.
class TreeBuilder : public nlohmann::json_sax<Json> {
 public:
  TreeBuilder(const InputText& input, const TokenPlaces& places) : input_(input), places_(places) {}

  JsonValue result() { return std::move(root_); }

  bool null() override { return add(JsonValue::Kind::null, places_.word(), "null"); }
  bool boolean(bool) override { return add(JsonValue::Kind::boolean, places_.word()); }
  bool number_integer(number_integer_t) override { return number(); }
  bool number_unsigned(number_unsigned_t) override { return number(); }
  bool number_float(number_float_t, const string_t&) override { return number(); }
  bool string(string_t& text) override {
    return add(JsonValue::Kind::string, places_.string(), text);
  }
  bool binary(binary_t&) override { return false; }  // not in text
  bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
  bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    std::vector<std::string>& keys = open_.back()->keys;
    if (!seen_.back().insert(key).second)
      input_.refuse(places_.string(), "the member " + quote(key) + " is said twice", "it once");
    keys.push_back(key);
    return true;
  }

  /// Gives the parser's message our form: "syntax error while parsing <context> - <wrong>; last
  /// read: '<text>'; expected <expected>".
  bool parse_error(std::size_t, const std::string& last,
                   const nlohmann::detail::exception& e) override {
    constexpr int number_overflow = 406;
    if (e.id == number_overflow) refuse_overflow();
    std::string wrong = e.what();
    std::string expected = "JSON";
    if (const auto at = wrong.find("syntax error"); at != std::string::npos) wrong.erase(0, at);
    if (const auto at = wrong.rfind("; expected "); at != std::string::npos) {
      expected = wrong.substr(at + 11);
      wrong.erase(at);
    }
    if (const auto at = wrong.find("; last read: "); at != std::string::npos) wrong.erase(at);
    const bool at_end =
        last.empty() || wrong.ends_with("end of input") || wrong.ends_with("missing closing quote");
    Position at = at_end ? places_.next() : places_.last();
    if (wrong.ends_with("string literal")) at = places_.string();
    if (wrong.ends_with("number literal") || wrong.ends_with("true literal") ||
        wrong.ends_with("false literal") || wrong.ends_with("null literal"))
      at = places_.word();
    input_.refuse(at, "JSON " + one_line(wrong), one_line(expected));
  }

 private:
  bool number() {
    return add(JsonValue::Kind::number, places_.word(), std::string(places_.word_text()));
  }

  [[noreturn]] void refuse_overflow() {
    NumberFault fault;
    if (!parse_number(places_.word_text(), fault))
      input_.refuse(places_.word(), fault.wrong, fault.expected);
    input_.refuse(places_.word(), quote(places_.word_text()) + " is too large for a JSON number",
                  "it as a string");
  }

  JsonValue& place_for_value() {
    if (open_.empty()) return root_;
    return open_.back()->items.emplace_back();
  }

  bool add(JsonValue::Kind kind, const Position& at, std::string text = {}) {
    JsonValue& value = place_for_value();
    value.kind = kind;
    value.at = at;
    value.text = std::move(text);
    return true;
  }

  bool open(JsonValue::Kind kind) {
    if (open_.size() == deepest_json)
      input_.refuse(places_.bracket(),
                    "JSON nested deeper than " + std::to_string(deepest_json) + " levels",
                    "a geometry");
    JsonValue& value = place_for_value();
    value.kind = kind;
    value.at = places_.bracket();
    // Stays valid: its siblings come only after it is closed.
    open_.push_back(&value);
    seen_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    seen_.pop_back();
    return true;
  }

  const InputText& input_;
  const TokenPlaces& places_;
  JsonValue root_;
  std::vector<JsonValue*> open_;
  std::vector<std::set<std::string>> seen_;
};

}  // namespace

const JsonValue* JsonValue::member(const std::string& key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

std::string describe(JsonValue::Kind kind) {
  switch (kind) {
    case JsonValue::Kind::null:
      return "null";
    case JsonValue::Kind::boolean:
      return "a boolean";
    case JsonValue::Kind::number:
      return "a number";
    case JsonValue::Kind::string:
      return "a string";
    case JsonValue::Kind::array:
      return "an array";
    case JsonValue::Kind::object:
      return "an object";
  }
  return {};
}

JsonValue parse_json(const InputText& input) {
  TokenPlaces places(input.text);
  TreeBuilder builder(input, places);
  const char* const first = input.text.data();
  const char* const last = first + input.text.size();
  Json::sax_parse(WatchedCharacter(first, &places), WatchedCharacter(last, &places), &builder);
  return builder.result();
}

}  // namespace oplus
