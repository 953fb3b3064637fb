// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/report.hpp"
#include "tests/bench/templates.hpp"

namespace oplus {

/// What the template benchmarks.md.mustache is filled with: what a run found.
PageData benchmarks_data(const Report& report);

/// What slide was to reach, what the run found, and whether that is it: "yes", "**no**", or "not
/// measured" where the run does not tell.
Table goals_of(const Report& report);

}  // namespace oplus
