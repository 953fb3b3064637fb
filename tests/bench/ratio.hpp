// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/report.hpp"

namespace oplus {

/// A ratio of what was measured. Of an engine that was ended it is a lower bound.
struct Ratio {
  double value;
  bool is_lower_bound;
};

/// "12.3", "> 971".
std::string ratio_text(const Ratio& ratio);

/// How many times as long as `base`, or as much memory, an engine takes; none where one of them has
/// no such number.
std::optional<Ratio> time_ratio(const Report& report, const RowReport& row,
                                const std::string& engine, const std::string& base);
std::optional<Ratio> memory_ratio(const Report& report, const RowReport& row,
                                  const std::string& engine, const std::string& base);

/// A lower bound as soon as one of them is. Requires: at least one.
Ratio geometric_mean(const std::vector<Ratio>& ratios);

}  // namespace oplus
