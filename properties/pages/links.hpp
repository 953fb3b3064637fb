// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace oplus {

/// The anchor that GitHub gives a heading: "Section 4.2.4: a `b`" has "section-424-a-b".
std::string anchor_of(const std::string& heading);

/// The headings of a page, without those inside code.
std::vector<std::string> headings_of(const std::string& page);

/// The pages of docs/, without their ending, that link to a statement's page: by statement, sorted.
/// Generated pages are left out.
std::map<std::string, std::vector<std::string>> citing_pages(const std::filesystem::path& docs);

/// The text for a statement's page: "docs/findings.md, on Theorem 2.3.2" becomes a link to the first
/// of the headings of that page that names Theorem 2.3.2, "docs/findings.md" one to the page.
std::string with_links_to_findings(const std::string& text,
                                   const std::vector<std::string>& headings);

/// What such a text names after "docs/findings.md, on " that is in no heading.
std::vector<std::string> missing_findings(const std::string& text,
                                          const std::vector<std::string>& headings);

}  // namespace oplus
