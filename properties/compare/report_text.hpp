// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "properties/compare/campaign_report.hpp"

namespace oplus {

/// For the terminal: a table or totals, as the command of the report has them; the verdict is the last
/// line.
std::string summary(const CampaignReport& report);

/// What a counterexample is: how engine and oracle differ, where its files are in the folder, and how to
/// see it again.
std::string explanation(const CampaignReport& report, const ShrunkFailure& found,
                        const std::string& folder);

/// For people.
std::string to_markdown(const CampaignReport& report);

/// For a CI: a suite a part, a case a source.
std::string to_junit(const CampaignReport& report);

/// The text of a report as the ending of its file says: .md, .xml, else JSON.
std::string report_text(const CampaignReport& report, const std::string& file);

/// Whether a file has one of the endings .md, .xml and .json, or is "-", which is standard output.
bool is_report_name(const std::string& file);

/// What became of some sources together, such as those of a part, in the order of the report.
struct CountedPart {
  std::string part;
  std::vector<CountedSource> sources;
  Tally all = {};
};
std::vector<CountedPart> parts_of(const CampaignReport& report);

/// "slide, rca".
std::string engines_in_words(const CampaignReport& report);

}  // namespace oplus
