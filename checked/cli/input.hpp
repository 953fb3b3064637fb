// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "checked/statistics.hpp"
#include "reference/definitions/given_sum.hpp"
#include "reference/definitions/minkowski_sum.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// What reading took.
struct ReadingTimes {
  Seconds reading{};
  Seconds validation{};
};

/// Read a file ("-" is standard input); say on standard error what reading repaired, and on a terminal
/// how far it is where it takes longer than a second. Add to the times, if given. Throw InvalidInput.
Region read_summand(const std::string& path, ReadingTimes* times = nullptr);
MinkowskiSum read_given_sum(const std::string& path);
GivenSum read_unchecked_sum(const std::string& path);

/// Throws UsageError where standard input is named more than once.
void require_one_standard_input(const std::vector<std::string>& paths);

}  // namespace oplus
