// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// Describes an engine's results, added up over the pairs of a row.
class Description {
 public:
  void count(const std::string& name, std::size_t number) {
    numbers_[name] += static_cast<double>(number);
  }

  /// Adds an exact result in canonical form: equal results give equal text.
  void say(const std::string& words) { said_ += words; }
  void say(const std::vector<Segment>& segments);

  /// Exact sums are in canonical form; chains of other sums are counted as they are.
  void add(const PlanarSet& sum, bool is_rounded = false);

  /// A sum that is to the left of chains, which become canonical if it is exact.
  void add(const std::vector<Chain>& chains, bool is_rounded);

  const std::map<std::string, double>& numbers() const { return numbers_; }

  /// "digest=… area=…": of 64 bits of the text, if it is not empty; and the total area of sums, exactly, or
  /// with 30 decimals where that is long.
  std::string label() const;

 private:
  std::map<std::string, double> numbers_;
  std::string said_;
  std::optional<Rational> area_;
};

}  // namespace oplus
