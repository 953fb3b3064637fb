// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <tuple>
#include <utility>

#include "properties/runner/classification.hpp"
#include "properties/runner/property_run.hpp"
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

std::set<std::string> class_names() {
  std::set<std::string> names;
  for (const auto& [name, value] : named(Classification{})) names.insert(name);
  return names;
}

const std::set<std::string>& kinds() {
  static const std::set<std::string> all = {"lemma",   "theorem", "corollary", "observation",
                                            "section", "table",   "equation",  "definition",
                                            "fact",    "law",     "step"};
  return all;
}

void add_defects_of_entry(const Statement& s, const std::set<std::string>& mutants,
                          std::vector<std::string>& defects) {
  const auto defect = [&](const std::string& what) { defects.push_back(s.id + ": " + what); };
  if (!kinds().count(s.kind()) || s.id == s.kind()) defect("the id does not start with a kind");
  if (s.title.empty() || s.statement.empty() || s.why.empty())
    defect("title, statement or why is missing");
  if (!s.check && !s.enumerate)
    defect("it has neither check nor enumeration");
  else if (!s.check && (s.cases > 0 || !s.sources.empty() || !s.promises.empty()))
    defect("without a check there is nothing to try on pairs");
  if (s.check && s.cases == 0) defect("a run has no case");
  if (s.check && s.sources.empty()) defect("it names no family");
  for (const Source& source : s.sources) {
    const Family* family = find_family(source.family);
    if (family == nullptr)
      defect("there is no family " + source.family);
    else if (source.largest < family->smallest || source.weight <= 0)
      defect("size or weight of family " + source.family + " leaves no pair");
  }
  for (const Promise& promise : s.promises) {
    if (!is_of_a_count(promise) && !class_names().count(promise.classification))
      defect("there is no class " + promise.classification);
    if (promise.percent < 1 || promise.percent > 100)
      defect("the promised share of " + promise.classification + " is no percentage");
  }
  if (s.kills.empty()) defect("it names no mutant that it kills");
  for (const std::string& name : s.kills)
    if (!mutants.count(name)) defect("there is no mutant " + name);
}

void add_defects_of_unregistered_files(const std::vector<Statement>& all,
                                       const std::filesystem::path& root,
                                       std::vector<std::string>& defects) {
  std::set<std::string> files;
  for (const Statement& s : all) files.insert(relative_file(s));
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(root / "properties/statements")) {
    const std::string file = entry.path().lexically_relative(root).string();
    const std::string name = entry.path().filename().string();
    const std::string kind = name.substr(0, name.find('_'));
    if (entry.path().extension() == ".cpp" && kinds().count(kind) && !files.count(file))
      defects.push_back(file + ": no statement is registered from it");
  }
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
  return all;
}

Registered::Registered(Statement statement) {
  registered_statements().push_back(std::move(statement));
}

std::string relative_file(const std::string& file) {
  return absolute_file(file).lexically_relative(source_root()).string();
}

std::string relative_file(const Statement& statement) { return relative_file(statement.file); }

std::vector<std::string> defects_of_entries(const std::vector<Statement>& statements,
                                            const std::vector<Mutant>& mutants) {
  std::vector<std::string> defects;
  std::set<std::string> ids, mutant_names, killed;
  for (const Mutant& m : mutants)
    if (!mutant_names.insert(m.name).second)
      defects.push_back(m.name + ": two mutants of this name");
  for (const Statement& s : statements) {
    if (!ids.insert(s.id).second) defects.push_back(s.id + ": two statements of this id");
    killed.insert(s.kills.begin(), s.kills.end());
    add_defects_of_entry(s, mutant_names, defects);
  }
  for (const Mutant& m : mutants)
    // Faults in reading and writing are found by the fuzz targets (docs/fuzz.md).
    if (!killed.count(m.name) && !m.file.starts_with("reference/io/"))
      defects.push_back(m.name + ": no statement names this mutant");
  return defects;
}

std::vector<std::string> defects_of_files(const std::vector<Statement>& statements,
                                          const std::filesystem::path& root) {
  if (!std::filesystem::is_directory(root / "properties"))
    return {root.string() + ": the source tree is not there"};
  std::vector<std::string> defects;
  for (const Statement& s : statements) {
    if (!std::filesystem::is_regular_file(absolute_file(s.file)))
      defects.push_back(s.id + ": there is no file " + s.file);
    if (!std::filesystem::is_regular_file(root / "docs/theorems" / (s.id + ".md")))
      defects.push_back(s.id + ": there is no page docs/theorems/" + s.id + ".md");
  }
  add_defects_of_unregistered_files(statements, root, defects);
  return defects;
}

}  // namespace oplus
