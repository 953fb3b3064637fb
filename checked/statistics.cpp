// SPDX-License-Identifier: MIT
#include "checked/statistics.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace oplus {

namespace {

auto named(std::string_view name) {
  return [name](const Statistic& statistic) { return statistic.name == name; };
}

}  // namespace

bool Statistics::contains(std::string_view name) const {
  return std::any_of(begin(), end(), named(name));
}

std::size_t Statistics::count(std::string_view name) const {
  return std::get<std::size_t>(value(name));
}

Seconds Statistics::seconds(std::string_view name) const { return std::get<Seconds>(value(name)); }

const Quantity& Statistics::value(std::string_view name) const {
  const auto found = std::find_if(begin(), end(), named(name));
  if (found == end()) throw std::out_of_range("no statistic is called " + std::string(name));
  return found->value;
}

}  // namespace oplus
