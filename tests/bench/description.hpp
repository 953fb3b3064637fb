// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"
#include "tests/bench/measurement.hpp"

namespace oplus {

/// Describes an engine's results, added up over the pairs of a row.
class Description {
 public:
  void count(const std::string& name, std::size_t number);

  /// Adds an exact result in canonical form: equal results give equal text.
  void say(const std::string& words) { said_ += words; }
  void say(const std::vector<Segment>& segments);

  /// Exact sums are in canonical form; chains of other sums are counted as they are.
  void add(const MinkowskiSum& sum, bool is_rounded = false);

  /// Adds the numbers, the total area, and a digest of 64 bits of the text, if it is not empty.
  void write_to(Measurement& measurement) const;

 private:
  std::map<std::string, double> numbers_;
  std::string said_;
  std::optional<Rational> area_;
};

}  // namespace oplus
