// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "properties/compare/campaign_report.hpp"

namespace oplus {

/// For the terminal: a table or totals, as the command of the report has them; the verdict is the last
/// line.
std::string summary(const CampaignReport& report);

/// Describes a counterexample: how engine and judge differ, where its files are, and how to reproduce it.
std::string explanation(const CampaignReport& report, const ShrunkFailure& found);

/// For people. `folder` is that of the Markdown's own file, for the links to pictures.
std::string to_markdown(const CampaignReport& report, const std::string& folder = "");

/// For a CI: a suite per part, a case per source, each with its own first pair that failed.
std::string to_junit(const CampaignReport& report);

/// The text of a report in the format of its file's ending: .md, .xml, else JSON.
std::string report_text(const CampaignReport& report, const std::string& file);

/// Whether a file has one of the endings .md, .xml and .json, or is "-", which is standard output.
bool is_report_name(const std::string& file);

/// The counts of some sources together, such as those of a part, in the order of the report.
struct CountedPart {
  std::string part;
  std::vector<CountedSource> sources;
  Tally all = {};
};
std::vector<CountedPart> parts_of(const CampaignReport& report);

/// "slide, rca".
std::string engines_in_words(const CampaignReport& report);

}  // namespace oplus
