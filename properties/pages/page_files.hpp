// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "properties/pages/theorem_page.hpp"

namespace oplus {

/// All generated pages. Requires: no defects of records.
std::vector<Page> all_pages(const Registry& registry);

/// Writes them below docs/ and removes pages and pictures of statements that do not exist any more.
/// Throws std::system_error.
void write_pages(const std::vector<Page>& pages, const std::filesystem::path& docs);

/// What is out of date below docs/, a line each: a page that is missing or has another text, a file
/// in docs/theorems/ that is not generated. The drawing of the graph is tested in
/// page_files_test.cpp.
std::vector<std::string> stale_files(const std::vector<Page>& pages,
                                     const std::filesystem::path& docs);

}  // namespace oplus
