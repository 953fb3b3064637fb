// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/json_values.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <variant>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string key_of(std::string_view name) {
  std::string key(name);
  std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) {
    return std::isalnum(c) ? static_cast<char>(std::tolower(c)) : '_';
  });
  return key;
}

Json value_of(std::size_t count) { return count; }
double rounded(Seconds seconds) { return std::round(seconds.count() * 1e6) / 1e6; }
Json value_of(Seconds seconds) { return rounded(seconds); }
Json value_of(const Rational& value) { return to_string(value); }

}  // namespace

Json json(const Point& p) { return Json::array({to_string(p.x), to_string(p.y)}); }

Json json(const Quantity& quantity) {
  return std::visit([](const auto& value) { return value_of(value); }, quantity);
}

Json json(const Statistics& statistics) {
  Json object = Json::object();
  for (const auto& [name, quantity] : statistics) object[key_of(name)] = json(quantity);
  return object;
}

namespace {

std::string text(std::size_t count) { return std::to_string(count); }

std::string text(Seconds seconds) { return std::to_string(rounded(seconds)); }

std::string text(const Rational& value) {
  const std::string exact = to_string(value);
  return exact.size() <= 60 ? exact : to_string(value, 6) + " (rounded)";
}

}  // namespace

Statistics statistics_of(const PlanarSet& sum) {
  return {{"outer chains", sum.outer.size()},
          {"holes", sum.holes.size()},
          {"dangling edges", sum.dangling_edges.size()},
          {"isolated vertices", sum.isolated_vertices.size()},
          {"area", area(sum)}};
}

std::string in_text(const Quantity& quantity) {
  return std::visit([](const auto& value) { return text(value); }, quantity);
}

}  // namespace oplus
