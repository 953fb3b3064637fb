// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/io/input_text.hpp"

namespace oplus {

/// A JSON value with its place. RapidJSON's own tree has neither places nor exact numbers.
struct JsonValue {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  Position at;
  std::string text;               ///< of a number as the input has it, of a string unescaped
  std::vector<JsonValue> items;   ///< of an array; of an object the members' values
  std::vector<std::string> keys;  ///< of an object's members

  /// Returns the first member with this key, or none.
  JsonValue* member(const std::string& key);
};

/// Returns "a number", "an array", ...
std::string describe(JsonValue::Kind kind);

/// Deeper values are refused: no geometry has them, and the tree's destructor is recursive.
inline constexpr std::size_t deepest_json = 64;

/// Throws InvalidInput where the input is not one JSON value, an object has a key twice, or values are
/// nested too deep.
/// Requires: the input contains no zero byte, at which RapidJSON stops.
JsonValue parse_json(const InputText& input);

}  // namespace oplus
