// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/report.hpp"
#include "tests/bench/templates.hpp"

namespace oplus {

/// The data of a run for the template benchmarks.md.mustache.
PageData benchmarks_data(const Report& report);

/// The goals for slide, the measured values, and whether they reach the goals: "yes", "**no**", or "not
/// measured".
Table goals_of(const Report& report);

}  // namespace oplus
