// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/crash_site.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace oplus {

namespace {

/// What follows the last `start` in its line.
std::optional<std::string> rest_of_line(const std::string& text, std::string_view start) {
  const std::size_t at = text.rfind(start);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t first = text.find_first_not_of(" :\t", at + start.size());
  const std::size_t end = text.find('\n', at + start.size());
  if (first == std::string::npos || first >= end) return std::string();
  return text.substr(first, end == std::string::npos ? end : end - first);
}

/// From the last of `folder` on: where a header is installed is no part of its name.
std::string below(const std::string& path, std::string_view folder) {
  const std::size_t at = path.rfind(folder);
  return at == std::string::npos ? path : path.substr(at + folder.size());
}

/// CGAL: "Expression : …", "File : …", "Line : …".
std::optional<std::string> cgal_site(const std::string& errors) {
  if (errors.find("CGAL error") == std::string::npos) return std::nullopt;
  const auto expression = rest_of_line(errors, "\nExpression");
  const auto file = rest_of_line(errors, "\nFile");
  const auto line = rest_of_line(errors, "\nLine");
  if (!file || !line) return std::nullopt;
  return below(*file, "include/") + ":" + *line + (expression ? ": " + *expression : "");
}

/// assert(): "program: FILE:LINE: FUNCTION: Assertion `EXPRESSION' failed."
std::optional<std::string> assert_site(const std::string& errors) {
  const std::size_t assertion = errors.rfind(": Assertion `");
  const std::size_t end = errors.rfind("' failed.");
  if (assertion == std::string::npos || end == std::string::npos || end < assertion)
    return std::nullopt;
  const std::size_t line_break = errors.rfind('\n', assertion);
  const std::size_t line = line_break == std::string::npos ? 0 : line_break + 1;
  const std::size_t file = errors.find(": ", line);
  const std::size_t file_end = errors.find(": ", file + 1);
  if (file >= assertion || file_end == std::string::npos) return std::nullopt;
  const std::size_t expression = errors.find('`', assertion) + 1;
  return below(errors.substr(file + 2, file_end - file - 2), "/") + ": " +
         errors.substr(expression, end - expression);
}

}  // namespace

std::string crash_site(const std::string& errors, const std::string& how_it_ended) {
  if (const auto site = cgal_site(errors)) return *site;
  if (const auto site = assert_site(errors)) return *site;
  if (const auto found = rest_of_line(errors, "ERROR: AddressSanitizer"))
    return "AddressSanitizer: " + found->substr(0, found->find(' '));
  if (const auto type = rest_of_line(errors, "terminate called after throwing an instance of"))
    return *type;
  return how_it_ended;
}

bool says_out_of_memory(const std::string& errors) {
  constexpr std::array words{
      "bad_alloc",    "annot allocate memory", "emory exhausted",         "MemoryError",
      "ut of memory", "OutOfMemory",           "ould not allocate memory"};
  return std::ranges::any_of(
      words, [&](const char* word) { return errors.find(word) != std::string::npos; });
}

}  // namespace oplus
