// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/bench/report.hpp"

namespace oplus {

/// docs/benchmarks.md: the template with its @MARKS@ replaced by what a run found.
/// Throws std::invalid_argument for a mark it does not know.
std::string page_of(const Report& report, const std::string& page_template);

}  // namespace oplus
