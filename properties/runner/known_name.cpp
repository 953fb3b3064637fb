// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/known_name.hpp"

#include <algorithm>
#include <numeric>

#include "checked/cli/usage_error.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

/// How many characters have to be inserted, removed or replaced (Levenshtein).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char c : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (c == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::function<void(const std::string&)> known_name(const std::string& what,
                                                   const std::vector<std::string>& names,
                                                   const std::string& hint) {
  return [=](const std::string& name) {
    if (std::ranges::count(names, name) > 0) return;
    const auto to = [&](const std::string& known) { return edit_distance(name, known); };
    const auto nearest = std::ranges::min_element(names, {}, to);
    const bool is_near = nearest != names.end() && 3 * to(*nearest) <= nearest->size();
    throw UsageError("unknown " + what + " " + quote(name) + "; " +
                     (is_near ? "did you mean " + *nearest + "? " : "") + hint);
  };
}

}  // namespace oplus
