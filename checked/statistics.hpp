// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <variant>
#include <vector>

#include "reference/definitions/values.hpp"

namespace oplus {

using Seconds = std::chrono::duration<double>;  ///< A time.

/// A count, a time, or an exact value such as an area.
using Quantity = std::variant<std::size_t, Seconds, Rational>;

/// A number and its name.
struct Statistic {
  std::string_view name;  ///< in words: "arrangement edges". Requires: a literal
  Quantity value;         ///< with its unit

  friend bool operator==(const Statistic&, const Statistic&) = default;
};

/// What a run did, in numbers: each has a name of its own; in the order in which they are printed.
class Statistics {
 public:
  Statistics() = default;                                          ///< none
  Statistics(std::initializer_list<Statistic> all) : all_(all) {}  ///< these, in this order

  auto begin() const { return all_.begin(); }  ///< Returns an iterator to the first Statistic.
  auto end() const { return all_.end(); }      ///< Returns the end of the range.

  /// Whether there is one of this name.
  bool contains(std::string_view name) const;

  /// Returns a count. Throws std::out_of_range for an unknown name, std::bad_variant_access for
  /// another unit.
  std::size_t count(std::string_view name) const;

  /// Returns a time. Throws as count does.
  Seconds seconds(std::string_view name) const;

  friend bool operator==(const Statistics&, const Statistics&) = default;

 private:
  const Quantity& value(std::string_view name) const;

  std::vector<Statistic> all_;
};

}  // namespace oplus
