// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "properties/pages/theorem_page.hpp"

namespace oplus {

/// All generated pages. Requires: no defects of records.
std::vector<Page> all_pages(const Registry& registry);

/// Writes them below docs/ and removes pages and pictures of statements that are no more.
/// Throws std::system_error.
void write_pages(const std::vector<Page>& pages, const std::filesystem::path& docs);

/// What is stale below docs/, a line each: a page that is missing or has another text, a file in
/// docs/theorems/ that is none of them. The drawing of the graph is looked at in tests/docs.
std::vector<std::string> stale_files(const std::vector<Page>& pages,
                                     const std::filesystem::path& docs);

}  // namespace oplus
