// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <variant>
#include <vector>

#include "reference/definitions/rational.hpp"

namespace oplus {

using Seconds = std::chrono::duration<double>;

/// A count, a time, or an exact value such as an area.
using Quantity = std::variant<std::size_t, Seconds, Rational>;

struct Statistic {
  std::string_view name;  ///< in words: "arrangement edges". Requires: a literal
  Quantity value;

  friend bool operator==(const Statistic&, const Statistic&) = default;
};

/// What a run did, in numbers: each has a name of its own; in the order in which they are printed.
class Statistics {
 public:
  Statistics() = default;
  Statistics(std::initializer_list<Statistic> all) : all_(all) {}

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

  bool contains(std::string_view name) const;

  /// Throw std::out_of_range for an unknown name, std::bad_variant_access for another unit.
  std::size_t count(std::string_view name) const;
  Seconds seconds(std::string_view name) const;

  friend bool operator==(const Statistics&, const Statistics&) = default;

 private:
  const Quantity& value(std::string_view name) const;

  std::vector<Statistic> all_;
};

/// Adds the time that `work` takes; returns what it returns.
template <typename Work>
auto timed(Seconds& total, Work work) {
  struct Clock {
    Seconds& total;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Clock() { total += std::chrono::steady_clock::now() - start; }
  } const clock{total};
  return work();
}

}  // namespace oplus
