// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "properties/pages/theorem_page.hpp"

namespace oplus {

/// The registry with the records docs/theorems/runs.json and kills.json.
/// Throws InvalidInput where one cannot be read.
Registry registry_with_records(const std::filesystem::path& docs);

/// What is missing in the records or no longer true of the registry, a line each: a statement without
/// a run, a mutant that a statement names without a kill, a record of neither.
std::vector<std::string> defects_of_records(const Registry& registry);

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
