// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "properties/runner/finding.hpp"
#include "properties/runner/property_run.hpp"

namespace oplus {

// What `oplus-check properties --json` says of a statement: docs/json.md.

/// `files`: where the shrunk counterexample went, if there is one.
nlohmann::ordered_json run_report(const Statement& statement, const PropertyRun& run,
                                  const std::optional<Finding>& files);

/// Of a statement on one pair.
nlohmann::ordered_json run_report(const Statement& statement, const Outcome& outcome);

}  // namespace oplus
