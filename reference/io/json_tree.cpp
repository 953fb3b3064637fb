// SPDX-License-Identifier: MIT
#include "reference/io/json_tree.hpp"

#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The text as RapidJSON reads it. RapidJSON refuses numbers that overflow a double, even though it
/// converts none here; so it is given only two digits of each sequence of digits.
class JsonStream {
 public:
  using Ch = char;

  explicit JsonStream(std::string_view text) : text_(text) {}

  char Peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  char Take() {
    const char taken = Peek();
    if (is_digit(taken) && is_digit(before_))
      while (is_digit(Peek())) ++at_;
    else
      ++at_;
    before_ = in_string ? '"' : taken;
    return taken;
  }
  std::size_t Tell() const { return at_; }

  // Unused, but RapidJSON requires them.
  char* PutBegin() { return nullptr; }
  void Put(char) {}
  void Flush() {}
  std::size_t PutEnd(char*) { return 0; }

  bool in_string = false;  ///< whether all digits count

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  char before_ = '"';
};

/// Builds the tree from RapidJSON's events.
class TreeBuilder : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, TreeBuilder> {
 public:
  explicit TreeBuilder(const InputText& input) : input_(input), stream_(input.text) {}

  JsonValue tree() {
    rapidjson::Reader reader;
    go_on(0);
    const rapidjson::ParseResult result =
        reader.Parse<rapidjson::kParseIterativeFlag | rapidjson::kParseNumbersAsStringsFlag |
                     rapidjson::kParseValidateEncodingFlag>(stream_, *this);
    if (result.IsError()) refuse(result.Code(), result.Offset());
    return std::move(root_);
  }

  bool Null() { return add(JsonValue::Kind::null, "null"); }
  bool Bool(bool) { return add(JsonValue::Kind::boolean); }
  bool RawNumber(const char*, rapidjson::SizeType, bool) {
    return add(JsonValue::Kind::number, std::string(rest().substr(0, stream_.Tell() - offset_)));
  }
  bool String(const char* text, rapidjson::SizeType size, bool) {
    return add(JsonValue::Kind::string, {text, size});
  }
  bool StartObject() { return open(JsonValue::Kind::object); }
  bool StartArray() { return open(JsonValue::Kind::array); }
  bool EndObject(rapidjson::SizeType) { return close(); }
  bool EndArray(rapidjson::SizeType) { return close(); }
  bool Key(const char* text, rapidjson::SizeType size, bool) {
    const std::string key(text, size);
    if (!seen_.back().insert(key).second)
      input_.refuse(position_, "the member " + quote(key) + " is repeated", "each member once");
    open_.back()->keys.push_back(key);
    return go_on(stream_.Tell());
  }

 private:
  /// Passes to where the first value or key behind an offset starts, if there is one.
  bool go_on(std::size_t from) {
    const std::size_t start = input_.text.find_first_not_of(" \t\r\n,:]}", from);
    const std::size_t before = offset_;
    for (; offset_ < std::min(start, input_.text.size()); ++offset_)
      position_.pass(input_.text[offset_]);
    input_.passed(before, offset_);
    stream_.in_string = rest().starts_with('"');
    return true;
  }

  std::string_view rest() const { return input_.text.substr(offset_); }

  [[noreturn]] void refuse(rapidjson::ParseErrorCode code, std::size_t offset);

  bool add(JsonValue::Kind kind, std::string text = {}) {
    JsonValue& value = open_.empty() ? root_ : open_.back()->items.emplace_back();
    value.kind = kind;
    value.at = position_;
    value.text = std::move(text);
    // RapidJSON has taken a value, but not an opening bracket.
    return go_on(std::max(stream_.Tell(), offset_ + 1));
  }

  bool open(JsonValue::Kind kind) {
    if (open_.size() == deepest_json)
      input_.refuse(position_,
                    "JSON nested deeper than " + std::to_string(deepest_json) + " levels",
                    "a geometry");
    add(kind);
    // Stays valid: its siblings come only after it is closed.
    open_.push_back(open_.empty() ? &root_ : &open_.back()->items.back());
    seen_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    seen_.pop_back();
    return go_on(stream_.Tell());
  }

  const InputText& input_;
  JsonStream stream_;
  std::size_t offset_ = 0;  ///< of the value or key that is read, and its place
  Position position_;
  JsonValue root_;
  std::vector<JsonValue*> open_;
  std::vector<std::set<std::string>> seen_;
};

/// What RapidJSON expects at an error; empty where the value itself is malformed.
std::string expected_at(rapidjson::ParseErrorCode code) {
  static const std::map<rapidjson::ParseErrorCode, std::string> expected{
      {rapidjson::kParseErrorDocumentRootNotSingular, "the end of the input"},
      {rapidjson::kParseErrorValueInvalid, "a value"},
      {rapidjson::kParseErrorObjectMissName, "the name of a member, in double quotes"},
      {rapidjson::kParseErrorObjectMissColon, "':'"},
      {rapidjson::kParseErrorObjectMissCommaOrCurlyBracket, "',' or '}'"},
      {rapidjson::kParseErrorArrayMissCommaOrSquareBracket, "',' or ']'"}};
  const auto found = expected.find(code);
  return found == expected.end() ? "" : found->second;
}

void TreeBuilder::refuse(rapidjson::ParseErrorCode code, std::size_t offset) {
  // A literal is wrong as a whole.
  if (code == rapidjson::kParseErrorValueInvalid) offset = std::min(offset, offset_);
  Position at;
  for (const char c : input_.text.substr(0, offset)) at.pass(c);
  const std::string expected = expected_at(code);
  if (expected.empty()) {
    const std::string_view wrong = rapidjson::GetParseError_En(code);
    input_.refuse(at, "JSON: " + std::string(wrong.substr(0, wrong.find('.'))), "JSON");
  }
  constexpr std::string_view between = " \t\r\n[]{},:\"";
  const std::string_view here = input_.text.substr(offset);
  const bool is_word = !here.empty() && between.find(here[0]) == std::string_view::npos;
  const std::size_t size = is_word ? here.find_first_of(between) : 1;
  input_.refuse(at, describe(Token{here.substr(0, size), at}) + " in JSON", expected);
}

}  // namespace

JsonValue* JsonValue::member(const std::string& key) {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

std::string describe(JsonValue::Kind kind) {
  constexpr std::array names{"null", "a boolean", "a number", "a string", "an array", "an object"};
  return names.at(static_cast<std::size_t>(kind));
}

JsonValue parse_json(const InputText& input) { return TreeBuilder(input).tree(); }

}  // namespace oplus
