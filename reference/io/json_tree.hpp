// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/io/input_text.hpp"

namespace oplus {

class JsonTree;

/// A place in a text.
struct TextPlace {
  std::size_t at = 0;  ///< how many bytes are before it
  Position position = {};
};

/// A value in a tree, which must outlive it. An array's items are its range.
class JsonValue {
 public:
  enum class Kind { null, boolean, number, string, array, object };

  class Iterator {
   public:
    Iterator(const JsonTree& tree, std::size_t node) : tree_(&tree), node_(node) {}
    JsonValue operator*() const { return {*tree_, node_}; }
    Iterator& operator++();
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const JsonTree* tree_;
    std::size_t node_;
  };

  JsonValue(const JsonTree& tree, std::size_t node) : tree_(&tree), node_(node) {}

  Kind kind() const;
  Position at() const;

  /// Of a number as the input has it, of a string unescaped.
  std::string_view text() const;

  /// The items of an array; of any other value none.
  Iterator begin() const;
  Iterator end() const;

  /// Counts them.
  std::size_t size() const;

  /// The keys and members of an object in their order; of any other value none.
  std::vector<std::pair<std::string_view, JsonValue>> members() const;

  /// Returns the member of an object with this key, or none.
  std::optional<JsonValue> member(std::string_view key) const;

 private:
  const JsonTree* tree_;
  std::size_t node_;
};

/// The values of a JSON text with their places, one after another: 16 bytes each. RapidJSON's own tree has
/// neither places nor exact numbers.
class JsonTree {
 public:
  /// Throws InvalidInput where the input is not one JSON value, an object has a key twice, or values are
  /// nested too deep.
  /// Requires: the input contains no zero byte, at which RapidJSON stops, and outlives the tree.
  explicit JsonTree(const InputText& input);

  /// The value at a place, which moves behind it: to the end of the input, or to an object in a later line, which
  /// may follow an object. Throws InvalidInput where anything else follows.
  JsonTree(const InputText& input, TextPlace& place);

  JsonValue root() const { return {*this, 0}; }

 private:
  friend class JsonValue;
  friend class TreeBuilder;

  /// An object's members are their keys, as strings, each before its value.
  struct Node {
    std::size_t at;   ///< where the value starts in the text; its first character tells its kind
    std::size_t end;  ///< of an array or object: the node behind its last; of others: where it ends
  };

  std::size_t next(std::size_t node) const;
  std::size_t behind_blanks(std::size_t at) const;
  Position place(std::size_t at) const;

  std::string_view text_;
  std::vector<Node> nodes_;
  std::map<std::size_t, std::string> unescaped_;  ///< by node, of the strings with escapes
  TextPlace start_;                               ///< of the value
  mutable TextPlace known_;                       ///< where a position was asked for last
};

/// Returns "a number", "an array", ...
std::string describe(JsonValue::Kind kind);

/// Deeper values are refused: no geometry has them.
inline constexpr std::size_t deepest_json = 64;

}  // namespace oplus
