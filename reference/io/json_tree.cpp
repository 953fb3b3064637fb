// SPDX-License-Identifier: MIT
#include "reference/io/json_tree.hpp"

#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <array>
#include <set>

#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The text as RapidJSON reads it. RapidJSON refuses numbers that overflow a double, even though it
/// converts none here; so it is given only two digits of each sequence of digits.
class JsonStream {
 public:
  using Ch = char;

  JsonStream(std::string_view text, std::size_t at) : text_(text), at_(at) {}

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
  std::size_t at_;
  char before_ = '"';
};

}  // namespace

/// Builds a tree from RapidJSON's events.
class TreeBuilder : public rapidjson::BaseReaderHandler<rapidjson::UTF8<>, TreeBuilder> {
 public:
  TreeBuilder(const InputText& input, JsonTree& tree, std::size_t from)
      : input_(input), tree_(tree), stream_(input.text, from), offset_(from) {}

  /// Returns where the value ends.
  std::size_t build() {
    rapidjson::Reader reader;
    go_on(0);
    const rapidjson::ParseResult result =
        reader.Parse<rapidjson::kParseIterativeFlag | rapidjson::kParseNumbersAsStringsFlag |
                     rapidjson::kParseStopWhenDoneFlag | rapidjson::kParseValidateEncodingFlag>(
            stream_, *this);
    if (result.IsError()) refuse(result.Code(), result.Offset());
    return stream_.Tell();
  }

  [[noreturn]] void refuse(rapidjson::ParseErrorCode code, std::size_t offset);

  bool Null() { return add(); }
  bool Bool(bool) { return add(); }
  bool RawNumber(const char*, rapidjson::SizeType, bool) { return add(); }
  bool String(const char* text, rapidjson::SizeType size, bool) {
    const std::size_t written = stream_.Tell() - offset_ - 2;  // between the quotes
    if (size != written) tree_.unescaped_.emplace(tree_.nodes_.size(), std::string(text, size));
    return add();
  }
  bool StartObject() { return open(); }
  bool StartArray() { return open(); }
  bool EndObject(rapidjson::SizeType) { return close(); }
  bool EndArray(rapidjson::SizeType) { return close(); }
  bool Key(const char* text, rapidjson::SizeType size, bool is_copy) {
    const std::string key(text, size);
    if (!open_.back().keys.insert(key).second)
      input_.refuse(tree_.place(offset_), "the member " + quote(key) + " is repeated",
                    "each member once");
    return String(text, size, is_copy);
  }

 private:
  struct Open {
    std::size_t node;
    std::set<std::string> keys;
  };

  /// Passes to where the first value or key behind an offset starts, if there is one.
  bool go_on(std::size_t from) {
    constexpr auto is_between = [](char c) {
      return c == ' ' || c == ',' || c == '\n' || c == ']' || c == '\t' || c == '\r' || c == ':' ||
             c == '}';
    };
    const std::size_t before = offset_;
    for (offset_ = std::max(offset_, from);
         offset_ < input_.text.size() && is_between(input_.text[offset_]);)
      ++offset_;
    input_.passed(before, offset_);
    stream_.in_string = offset_ < input_.text.size() && input_.text[offset_] == '"';
    return true;
  }

  bool add() {
    tree_.nodes_.push_back({offset_, stream_.Tell()});
    // RapidJSON has taken a value, but not an opening bracket.
    return go_on(std::max(stream_.Tell(), offset_ + 1));
  }

  bool open() {
    if (open_.size() == deepest_json)
      input_.refuse(tree_.place(offset_),
                    "JSON nested deeper than " + std::to_string(deepest_json) + " levels",
                    "a geometry");
    open_.push_back({tree_.nodes_.size(), {}});
    return add();
  }

  bool close() {
    tree_.nodes_[open_.back().node].end = tree_.nodes_.size();
    open_.pop_back();
    return go_on(stream_.Tell());
  }

  const InputText& input_;
  JsonTree& tree_;
  JsonStream stream_;
  std::size_t offset_;  ///< of the value or key that is read
  std::vector<Open> open_;
};

namespace {

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

}  // namespace

void TreeBuilder::refuse(rapidjson::ParseErrorCode code, std::size_t offset) {
  // A literal is wrong as a whole.
  if (code == rapidjson::kParseErrorValueInvalid) offset = std::min(offset, offset_);
  const Position at = tree_.place(std::min(offset, input_.text.size()));
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

JsonTree::JsonTree(const InputText& input) : text_(input.text) {
  TreeBuilder builder(input, *this, 0);
  if (const std::size_t next = behind_blanks(builder.build()); next != text_.size())
    builder.refuse(rapidjson::kParseErrorDocumentRootNotSingular, next);
}

JsonTree::JsonTree(const InputText& input, TextPlace& place)
    : text_(input.text), start_(place), known_(place) {
  TreeBuilder builder(input, *this, place.at);
  const std::size_t end = builder.build(), next = behind_blanks(end);
  const bool is_line = text_.substr(end, next - end).find('\n') != std::string_view::npos;
  if (next != text_.size() &&
      !(root().kind() == JsonValue::Kind::object && is_line && text_[next] == '{'))
    builder.refuse(rapidjson::kParseErrorDocumentRootNotSingular, next);
  place = {next, this->place(next)};
}

std::size_t JsonTree::behind_blanks(std::size_t at) const {
  return std::min(text_.find_first_not_of(" \t\r\n", at), text_.size());
}

std::size_t JsonTree::next(std::size_t node) const {
  const char first = text_[nodes_[node].at];
  return first == '[' || first == '{' ? nodes_[node].end : node + 1;
}

Position JsonTree::place(std::size_t at) const {
  if (at < known_.at) {
    const std::string_view back = text_.substr(at, known_.at - at);
    const auto lines = static_cast<std::size_t>(std::count(back.begin(), back.end(), '\n'));
    const std::size_t last = text_.substr(start_.at, at - start_.at).rfind('\n');
    if (lines == 0)
      known_ = {at, {known_.position.line, known_.position.column - back.size()}};
    else if (last == std::string_view::npos)
      known_ = start_;
    else
      known_ = {at, {known_.position.line - lines, at - start_.at - last}};
  }
  for (; known_.at < at; ++known_.at) known_.position.pass(text_[known_.at]);
  return known_.position;
}

JsonValue::Iterator& JsonValue::Iterator::operator++() {
  node_ = tree_->next(node_);
  return *this;
}

JsonValue::Kind JsonValue::kind() const {
  switch (tree_->text_[tree_->nodes_[node_].at]) {
    case 'n':
      return Kind::null;
    case 't':
    case 'f':
      return Kind::boolean;
    case '"':
      return Kind::string;
    case '[':
      return Kind::array;
    case '{':
      return Kind::object;
    default:
      return Kind::number;
  }
}

Position JsonValue::at() const { return tree_->place(tree_->nodes_[node_].at); }

std::string_view JsonValue::text() const {
  const JsonTree::Node& node = tree_->nodes_[node_];
  const std::string_view written = tree_->text_.substr(node.at, node.end - node.at);
  if (kind() != Kind::string) return written;
  const auto unescaped = tree_->unescaped_.find(node_);
  return unescaped == tree_->unescaped_.end() ? written.substr(1, written.size() - 2)
                                              : unescaped->second;
}

JsonValue::Iterator JsonValue::begin() const {
  return {*tree_, kind() == Kind::array ? node_ + 1 : tree_->next(node_)};
}

JsonValue::Iterator JsonValue::end() const { return {*tree_, tree_->next(node_)}; }

std::size_t JsonValue::size() const {
  std::size_t count = 0;
  for (Iterator item = begin(); item != end(); ++item) ++count;
  return count;
}

std::vector<std::pair<std::string_view, JsonValue>> JsonValue::members() const {
  std::vector<std::pair<std::string_view, JsonValue>> result;
  if (kind() != Kind::object) return result;
  for (std::size_t name = node_ + 1; name != tree_->next(node_);) {
    const std::size_t value = tree_->next(name);
    result.emplace_back(JsonValue(*tree_, name).text(), JsonValue(*tree_, value));
    name = tree_->next(value);
  }
  return result;
}

std::optional<JsonValue> JsonValue::member(std::string_view key) const {
  if (kind() != Kind::object) return std::nullopt;
  for (std::size_t name = node_ + 1; name != tree_->next(node_);) {
    const std::size_t value = tree_->next(name);
    if (JsonValue(*tree_, name).text() == key) return JsonValue(*tree_, value);
    name = tree_->next(value);
  }
  return std::nullopt;
}

std::string describe(JsonValue::Kind kind) {
  constexpr std::array names{"null", "a boolean", "a number", "a string", "an array", "an object"};
  return names.at(static_cast<std::size_t>(kind));
}

}  // namespace oplus
