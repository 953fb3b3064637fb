// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"
#include "tests/bench/measurement.hpp"

namespace oplus {

/// What an engine's results are made of, added up over the pairs of a row.
class Description {
 public:
  void count(const std::string& name, std::size_t number);

  /// Says an exact result in canonical form: equal results in equal words.
  void say(const std::string& words) { said_ += words; }
  void say(const std::vector<Segment>& segments);

  /// Exact sums are in canonical form; of others the chains are counted as they are.
  void add(const MinkowskiSum& sum, bool is_rounded = false);

  /// Adds the numbers, the whole area, and a digest of what was said, if anything was: 64 bits.
  void write_to(Measurement& measurement) const;

 private:
  std::map<std::string, double> numbers_;
  std::string said_;
  std::optional<Rational> area_;
};

}  // namespace oplus
