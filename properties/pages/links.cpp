// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/links.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

#include "reference/io/file_text.hpp"

namespace oplus {

namespace {

namespace fs = std::filesystem;

const std::set<std::string> generated_pages = {"theorems", "mutants"};

/// "Theorem 2.3.2" in the first group, where a section is named.
const std::regex& mention_of_findings() {
  static const std::regex mention("docs/findings\\.md(?:, on ([A-Z][a-z]+ [0-9](?:\\.?[0-9])*))?");
  return mention;
}

/// The first heading that contains the name, not followed by another digit; or empty.
std::string heading_with(const std::string& name, const std::vector<std::string>& headings) {
  const auto has_name = [&](const std::string& heading) {
    const std::size_t at = heading.find(name), end = at + name.size();
    return at != std::string::npos &&
           (end == heading.size() || std::isdigit(static_cast<unsigned char>(heading[end])) == 0);
  };
  const auto found = std::ranges::find_if(headings, has_name);
  return found == headings.end() ? "" : *found;
}

std::vector<std::smatch> mentions(const std::string& text) {
  return {std::sregex_iterator(text.begin(), text.end(), mention_of_findings()), {}};
}

}  // namespace

std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ' || c == '-')
      anchor += '-';
    else if (byte >= 0x80 || c == '_' || std::isalnum(byte) != 0)
      anchor += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
  }
  return anchor;
}

std::vector<std::string> headings_of(const std::string& page) {
  std::vector<std::string> headings;
  std::istringstream lines(page);
  bool in_code = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) in_code = !in_code;
    const std::size_t level = line.find_first_not_of('#');
    if (!in_code && level != 0 && level != std::string::npos && line[level] == ' ')
      headings.push_back(line.substr(level + 1));
  }
  return headings;
}

std::map<std::string, std::vector<std::string>> citing_pages(const fs::path& docs) {
  static const std::regex link("\\]\\(theorems/([^)#]+)\\.md[)#]");
  std::map<std::string, std::set<std::string>> found;
  for (const auto& entry : fs::directory_iterator(docs)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".md" || generated_pages.contains(name)) continue;
    const std::string page = text_of_file(entry.path(), "a page");
    for (std::sregex_iterator it(page.begin(), page.end(), link); it != std::sregex_iterator();
         ++it)
      found[it->str(1)].insert(name);
  }
  std::map<std::string, std::vector<std::string>> result;
  for (const auto& [statement, names] : found) result[statement] = {names.begin(), names.end()};
  return result;
}

std::string with_links_to_findings(const std::string& text,
                                   const std::vector<std::string>& headings) {
  std::string linked;
  auto from = text.begin();
  for (const std::smatch& mention : mentions(text)) {
    linked.append(from, mention[0].first);
    const std::string heading = heading_with(mention.str(1), headings);
    linked += "[" + mention.str() + "](../findings.md" +
              (mention.str(1).empty() ? "" : "#" + anchor_of(heading)) + ")";
    from = mention[0].second;
  }
  return linked.append(from, text.end());
}

std::vector<std::string> missing_findings(const std::string& text,
                                          const std::vector<std::string>& headings) {
  std::vector<std::string> missing;
  for (const std::smatch& mention : mentions(text))
    if (!mention.str(1).empty() && heading_with(mention.str(1), headings).empty())
      missing.push_back(mention.str(1));
  return missing;
}

}  // namespace oplus
