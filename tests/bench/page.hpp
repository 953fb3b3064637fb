// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/bench/report.hpp"
#include "tests/bench/templates.hpp"

namespace oplus {

/// What the template benchmarks.md.mustache is filled with: what a run found.
PageData benchmarks_data(const Report& report);

}  // namespace oplus
