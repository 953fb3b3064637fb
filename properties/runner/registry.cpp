// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"

#include <algorithm>
#include <regex>
#include <tuple>
#include <utility>

#include "properties/runner/source_tree.hpp"

namespace oplus {

namespace {

std::vector<Statement>& registered_statements() {
  static std::vector<Statement> all;
  return all;
}

/// The numbers of an id: {4, 1, 4} of "lemma-4.1.4"; empty for a fact.
std::vector<int> numbers_of(const std::string& id) {
  static const std::regex number("[0-9]+");
  std::vector<int> numbers;
  for (std::sregex_iterator it(id.begin(), id.end(), number); it != std::sregex_iterator(); ++it)
    numbers.push_back(std::stoi(it->str()));
  return numbers;
}

/// ccache shortens the names of source files to paths from the build folder, which is not where the program runs.
std::filesystem::path absolute_file(const std::filesystem::path& file) {
  if (file.is_absolute()) return file;
  std::filesystem::path absolute = source_root();
  for (const std::filesystem::path& part : file) {
    if (part != "..") absolute /= part;
  }
  return absolute;
}

}  // namespace

std::vector<Statement> statements() {
  std::vector<Statement> all = registered_statements();
  std::ranges::sort(all, {}, [](const Statement& s) {
    const std::vector<int> numbers = numbers_of(s.id);
    return std::tuple(numbers.empty(), numbers, s.id);
  });
  for (Statement& s : all) {
    const auto text = std::ranges::find(statement_texts(), s.id, &StatementText::id);
    if (text != statement_texts().end()) s.text = *text;
  }
  return all;
}

Registered::Registered(Statement statement) {
  registered_statements().push_back(std::move(statement));
}

Registered::Registered(Mixture pairs, Statement statement) {
  statement.sources = std::move(pairs.sources);
  statement.promises = std::move(pairs.promises);
  registered_statements().push_back(std::move(statement));
}

std::string relative_file(const std::string& file) {
  return absolute_file(file).lexically_relative(source_root()).string();
}

std::string relative_file(const Statement& statement) { return relative_file(statement.file); }

}  // namespace oplus
