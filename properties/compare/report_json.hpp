// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "properties/compare/campaign_report.hpp"

namespace oplus {

/// Returns the report as JSON (docs/json.md), with a checksum of all of it.
std::string sealed(const CampaignReport& report);

/// Returns the report of such a text. Throws InvalidInput where the text is not a report or its checksum
/// is wrong; `file` is what messages call it.
CampaignReport opened(const std::string& text, const std::string& file);

/// What differs first between the commands, versions and campaigns of two reports, as "seed is 2, not
/// 1"; empty where nothing does.
std::string other_campaign(const CampaignReport& expected, const CampaignReport& found);

}  // namespace oplus
