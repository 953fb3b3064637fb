// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/compare/campaign_report.hpp"

namespace oplus {

/// Names of the files of a counterexample, without a folder: they depend on what is in them.
struct CounterexampleFiles {
  std::string p, q, picture;
  std::string right = {}, given = {};  ///< empty: no such file

  std::vector<std::string> all() const;
};
CounterexampleFiles files_of(const ShrunkFailure& found);

/// Writes the files of all counterexamples into the report's folder, which is made if need be: the pair in
/// .dat, the right sum and the given one in WKT, and a picture. Throws std::system_error.
void write_counterexamples(const CampaignReport& report);

/// The line that asks the engine again, for a shell in the folder in which the command was run.
std::string replay_line(const CampaignReport& report, const ShrunkFailure& found);

}  // namespace oplus
