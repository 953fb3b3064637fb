// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/geometry_lines.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "checked/cli/input.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/invalid_region.hpp"
#include "reference/io/json_tree.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

/// A part of a line.
struct Field {
  std::string_view text;
  std::size_t column;       ///< of its first character, from one
  bool has_columns = true;  ///< whether columns in it are those of the line
};

[[noreturn]] void refuse(const PlacedLine& line, std::size_t column, const std::string& wrong,
                         const std::string& expected) {
  throw InvalidInput({line.file, line.number, column}, wrong, expected);
}

/// What is wrong with a field, as an error in the line.
[[noreturn]] void refuse(const PlacedLine& line, const Field& field, const std::string& name,
                         const InvalidInput& error, const std::string& hint = "") {
  const std::string_view all = error.what();
  constexpr std::string_view before_expected = "; expected ";
  const std::size_t wrong = all.find(error.wrong());
  const std::size_t expected = all.find(before_expected, wrong + error.wrong().size());
  const std::size_t column = error.where().column;
  refuse(line, field.has_columns && column != 0 ? field.column + column - 1 : field.column,
         (name.empty() ? "" : name + ": ") + error.wrong(),
         std::string(all.substr(expected + before_expected.size())) + hint);
}

ReadSet read_field(const PlacedLine& line, const Field& field, const std::string& name,
                   Overlaps overlaps, std::vector<std::string>& notes) {
  const auto read = [&] {
    try {
      return read_set(std::string(field.text), name.empty() ? "region" : name, {}, overlaps);
    } catch (const OverlappingComponents& error) {
      refuse(line, field, name, error, std::string("; ") + hint_at_union);
    } catch (const InvalidInput& error) {
      refuse(line, field, name, error);
    }
  };
  ReadSet set = read();
  if (is_unbounded(set.region))
    refuse(line, field.column, (name.empty() ? "" : name + ": ") + "the region is unbounded",
           "a bounded region");
  unite(set.region, overlaps);
  std::move(set.notes.begin(), set.notes.end(), std::back_inserter(notes));
  return set;
}

/// The bytes of a value of valid JSON, from its first one.
std::string_view value_at(std::string_view text) {
  std::size_t depth = 0, i = 0;
  do {
    const char c = text[i];
    if (c == '"') {
      for (++i; text[i] != '"'; ++i)
        if (text[i] == '\\') ++i;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (depth == 0) {  // a number, or a word such as null
      return text.substr(0, std::min(text.find_first_of(" \t\r,]}"), text.size()));
    }
    ++i;
  } while (depth > 0);
  return text.substr(0, i);
}

/// A member that is a geometry, or text that is one.
ReadSet read_member(const PlacedLine& line, JsonValue object, const std::string& key,
                    const std::string& name, Overlaps overlaps, std::vector<std::string>& notes) {
  const std::optional<JsonValue> value = object.member(key);
  if (!value)
    refuse(line, object.at().column, "an object without " + quote(key),
           R"({"p": GEOMETRY, "q": GEOMETRY})");
  const std::size_t column = value->at().column;
  if (value->kind() != JsonValue::Kind::string)
    return read_field(line, {value_at(line.text.substr(column - 1)), column}, name, overlaps,
                      notes);
  const std::string_view text = value->text();
  const bool is_as_written = line.text.substr(column, text.size()) == text;
  return read_field(line, {text, column + (is_as_written ? 1 : 0), is_as_written}, name, overlaps,
                    notes);
}

PairLine read_json_line(const PlacedLine& line, Overlaps overlaps, const TakeId& take_id) {
  if (const std::size_t zero = line.text.find('\0'); zero != std::string_view::npos)
    refuse(line, zero + 1, "the byte " + quote(line.text.substr(zero, 1)) + " is not text",
           "a JSON object");
  const InputText input{line.file, line.text};
  const std::optional<JsonTree> tree = [&] {
    try {
      return std::optional<JsonTree>(std::in_place, input);
    } catch (const InvalidInput& error) {
      refuse(line, {line.text, 1}, "", error);
    }
  }();
  const JsonValue object = tree->root();
  if (const std::optional<JsonValue> id = object.member("id"))
    take_id(value_at(line.text.substr(id->at().column - 1)));
  PairLine pair;
  pair.p = read_member(line, object, "p", "P", overlaps, pair.notes);
  pair.q = read_member(line, object, "q", "Q", overlaps, pair.notes);
  return pair;
}

}  // namespace

bool is_blank_or_comment(std::string_view line) {
  const auto first = std::find_if_not(line.begin(), line.end(), is_blank);
  return first == line.end() || *first == '#';
}

PairLine read_pair_line(const PlacedLine& line, Overlaps overlaps, const TakeId& take_id) {
  const std::size_t tab = line.text.find('\t');
  if (tab == std::string_view::npos) {
    if (*std::find_if_not(line.text.begin(), line.text.end(), is_blank) == '{')
      return read_json_line(line, overlaps, take_id);
    refuse(line, 0, "one field", "two geometries with a tab between them, or a JSON object");
  }
  if (line.text.find('\t', tab + 1) != std::string_view::npos)
    refuse(
        line, 0,
        counted(1 + static_cast<std::size_t>(std::count(line.text.begin(), line.text.end(), '\t')),
                "field", "fields"),
        "two geometries with one tab between them");
  PairLine pair;
  pair.p = read_field(line, {line.text.substr(0, tab), 1}, "P", overlaps, pair.notes);
  pair.q = read_field(line, {line.text.substr(tab + 1), tab + 2}, "Q", overlaps, pair.notes);
  return pair;
}

PartLine read_part_line(const PlacedLine& line, Overlaps overlaps) {
  PartLine part;
  Field field{line.text, 1};
  if (const std::size_t tab = line.text.find('\t'); tab != std::string_view::npos) {
    part.name = line.text.substr(0, tab);
    field = {line.text.substr(tab + 1), tab + 2};
    if (field.text.find('\t') != std::string_view::npos)
      refuse(line, 0, "more than one tab", "a geometry, or its name, a tab, and the geometry");
  }
  part.set = read_field(line, field, "", overlaps, part.notes);
  return part;
}

}  // namespace oplus
