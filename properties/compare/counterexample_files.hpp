// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/compare/campaign_report.hpp"

namespace oplus {

/// Names of the files of a counterexample, without a folder: they depend on what is in them.
struct CounterexampleFiles {
  std::string p, q, picture;
  std::string right = {}, given = {};  ///< empty: there is none

  std::vector<std::string> all() const;
};
CounterexampleFiles files_of(const ShrunkFailure& found);

/// Writes the files of all counterexamples into a folder, which is made if need be: the pair in .dat, the
/// right sum and the given one in WKT, and a picture. Throws std::system_error.
void write_counterexamples(const CampaignReport& report, const std::string& folder);

/// The line that asks the engine again, for a shell in a folder from which `folder` leads to the files;
/// empty: in that of the files.
std::string replay_line(const CampaignReport& report, const ShrunkFailure& found,
                        const std::string& folder);

}  // namespace oplus
