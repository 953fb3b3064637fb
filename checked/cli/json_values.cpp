// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/json_values.hpp"

#include <algorithm>
#include <cctype>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string key_of(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return std::isalnum(c) ? static_cast<char>(std::tolower(c)) : '_';
  });
  return name;
}

Json value_of(const std::string& name, const std::string& value) {
  if (name.starts_with("seconds")) return std::stod(value);
  const bool is_count =
      value.size() < 19 &&
      std::all_of(value.begin(), value.end(), [](unsigned char c) { return std::isdigit(c); });
  return is_count ? Json(std::stoull(value)) : Json(value);
}

}  // namespace

Json json(const Point& p) { return Json::array({to_string(p.x), to_string(p.y)}); }

Json json(const Statistics& statistics) {
  Json object = Json::object();
  for (const auto& [name, value] : statistics) object[key_of(name)] = value_of(name, value);
  return object;
}

Json json_statistics_of(const MinkowskiSum& sum) {
  Json object = json(statistics_of(sum));
  object["area"] = to_string(area(sum));
  return object;
}

}  // namespace oplus
