// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/definitions/region.hpp"
#include "reference/io/json_tree.hpp"
#include "reference/io/placed_geometry.hpp"

namespace oplus::layouts {

/// A value of a JSON text of which a format says what it is. All functions throw InvalidInput where it is not.
class JsonFields {
 public:
  /// `name` is how messages call it: 'items'. The input and the tree must outlive it.
  JsonFields(const InputText& input, JsonValue value, std::string name)
      : input_(input), value_(value), name_(std::move(name)) {}

  const JsonValue& value() const { return value_; }
  Position at() const { return value_.at(); }
  std::size_t line() const { return at().line; }

  JsonFields operator[](const std::string& key) const;
  std::optional<JsonFields> find(const std::string& key) const;
  std::vector<JsonFields> items() const;
  /// The members of an object, by their keys.
  std::vector<std::pair<std::string, JsonFields>> members() const;

  Rational number() const;
  int integer() const;
  std::string text() const;
  Point point() const;  ///< of [x, y]

  /// The name of a number or a string, as it is written.
  std::string label() const;

  [[noreturn]] void refuse(const std::string& wrong, const std::string& expected) const {
    input_.refuse(at(), wrong, expected);
  }

 private:
  void require(JsonValue::Kind kind) const;

  const InputText& input_;
  JsonValue value_;
  std::string name_;
};

}  // namespace oplus::layouts
