// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/bench/report.hpp"

namespace oplus {

/// Something slide was to reach, and what a run found.
struct Goal {
  std::string text;
  std::string measured;
  std::optional<bool> reached;  ///< none where the run does not tell
};

std::vector<Goal> goals_of(const Report& report);

}  // namespace oplus
