// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/page_files.hpp"

#include <algorithm>
#include <set>

#include "properties/pages/index_pages.hpp"
#include "properties/pages/statement_graph.hpp"
#include "properties/pages/strength.hpp"
#include "properties/runner/registry.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

namespace fs = std::filesystem;

const char* const records_and_drawing[] = {"theorems/runs.json", "theorems/kills.json",
                                           "theorems/graph.svg"};

/// Files below docs/theorems/ that are not generated.
std::vector<fs::path> superfluous_files(const std::vector<Page>& pages, const fs::path& docs) {
  std::set<std::string> known(std::begin(records_and_drawing), std::end(records_and_drawing));
  for (const Page& page : pages) known.insert(page.path);
  std::vector<fs::path> result;
  if (!fs::is_directory(docs / "theorems")) return result;
  for (const auto& entry : fs::recursive_directory_iterator(docs / "theorems"))
    if (entry.is_regular_file() && !known.contains(entry.path().lexically_relative(docs).string()))
      result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

std::vector<Page> all_pages(const Registry& registry) {
  std::vector<Page> pages = {
      theorems_page(registry),
      mutants_page(registry),
      graph_page(),
      {"theorems/graph.dot", to_dot(registry.statements, [&](const Statement& s) {
         return NodeColours{colour(strength(registry, s)), border_colour(registry, s)};
       })}};
  for (const Statement& s : registry.statements)
    for (Page& page : theorem_pages(registry, s)) pages.push_back(std::move(page));
  return pages;
}

void write_pages(const std::vector<Page>& pages, const fs::path& docs) {
  fs::create_directories(docs / "theorems/pictures");
  for (const Page& page : pages) write_file((docs / page.path).string(), page.text);
  for (const fs::path& file : superfluous_files(pages, docs)) fs::remove(file);
}

std::vector<std::string> stale_files(const std::vector<Page>& pages, const fs::path& docs) {
  std::vector<std::string> stale;
  for (const Page& page : pages) {
    if (!fs::is_regular_file(docs / page.path))
      stale.push_back(page.path + ": missing");
    else if (text_of_file(docs / page.path, "a page") != page.text)
      stale.push_back(page.path + ": out of date");
  }
  for (const fs::path& file : superfluous_files(pages, docs))
    stale.push_back(file.lexically_relative(docs).string() + ": not generated");
  return stale;
}

}  // namespace oplus
