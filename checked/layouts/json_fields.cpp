// SPDX-License-Identifier: MIT
#include "checked/layouts/json_fields.hpp"

#include "reference/io/number.hpp"
#include "reference/io/quoting.hpp"

namespace oplus::layouts {

using Kind = JsonValue::Kind;

void JsonFields::require(Kind kind) const {
  if (value_.kind() != kind) refuse(name_ + " is " + describe(value_.kind()), describe(kind));
}

JsonFields JsonFields::operator[](const std::string& key) const {
  std::optional<JsonFields> found = find(key);
  if (!found) refuse(name_ + " is without " + quote(key), quote(key));
  return *std::move(found);
}

std::optional<JsonFields> JsonFields::find(const std::string& key) const {
  require(Kind::object);
  const std::optional<JsonValue> found = value_.member(key);
  if (!found) return std::nullopt;
  return JsonFields(input_, *found, quote(key));
}

std::vector<JsonFields> JsonFields::items() const {
  require(Kind::array);
  std::vector<JsonFields> all;
  for (const JsonValue item : value_) all.emplace_back(input_, item, "an item of " + name_);
  return all;
}

std::vector<std::pair<std::string, JsonFields>> JsonFields::members() const {
  require(Kind::object);
  std::vector<std::pair<std::string, JsonFields>> all;
  for (const auto& [key, value] : value_.members())
    all.emplace_back(key, JsonFields(input_, value, quote(key)));
  return all;
}

Rational JsonFields::number() const {
  if (value_.kind() != Kind::string) require(Kind::number);
  NumberFault fault;
  std::optional<Rational> value = parse_number(value_.text(), fault);
  if (!value) refuse(name_ + ": " + fault.wrong, fault.expected);
  return *std::move(value);
}

int JsonFields::integer() const {
  const Rational value = number();
  if (value.get_den() != 1 || !value.get_num().fits_sint_p())
    refuse(name_ + " is " + quote(value_.text()), "an integer");
  return static_cast<int>(value.get_num().get_si());
}

std::string JsonFields::text() const {
  require(Kind::string);
  return std::string(value_.text());
}

Point JsonFields::point() const {
  const std::vector<JsonFields> both = items();
  if (both.size() != 2)
    refuse(name_ + " has " + std::to_string(both.size()) + " items", "two numbers, [x, y]");
  return {both[0].number(), both[1].number()};
}

std::string JsonFields::label() const {
  if (value_.kind() != Kind::string) require(Kind::number);
  return std::string(value_.text());
}

}  // namespace oplus::layouts
