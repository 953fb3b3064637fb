// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/conformance_sources.hpp"

#include <algorithm>

#include "properties/compare/sources.hpp"
#include "properties/runner/finding.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

/// Kept for the life of the program: tasks point at them.
const std::vector<Statement>& statements_on_results() {
  static const std::vector<Statement> all = [] {
    std::vector<Statement> kept = statements();
    std::erase_if(kept, [](const Statement& s) { return !s.of_engine; });
    return kept;
  }();
  return all;
}

/// Pairs of a statement's own sources in proportion to their weights, each from its smallest size to its
/// largest, and again.
TaskSource statement_source(const std::string& part, const Statement& statement, std::size_t count,
                            std::uint64_t seed) {
  std::vector<const Source*> in_turn;
  for (const Source& source : statement.sources)
    in_turn.insert(in_turn.end(), static_cast<std::size_t>(source.weight), &source);
  return {part, statement.id, count, [in_turn, &statement, seed](std::size_t i) {
            const Source& source = *in_turn[i % in_turn.size()];
            const Family& family = *find_family(source.family);
            const std::size_t largest = std::max(source.largest, family.smallest);
            const std::size_t n =
                family.smallest + i / in_turn.size() % (largest - family.smallest + 1);
            Task task = generated_pair(family, n, seed_of(statement.id, seed) + i);
            task.statement = &statement;
            return task;
          }};
}

}  // namespace

const std::vector<std::string>& conformance_parts() {
  static const std::vector<std::string> parts = {"grids", "corpus", "families", "statements",
                                                 "laws"};
  return parts;
}

std::vector<TaskSource> conformance_sources(const ConformanceChoice& choice) {
  const auto is_chosen = [&](const std::string& part) {
    return choice.parts.empty() || std::ranges::count(choice.parts, part) > 0;
  };
  // The number of pairs for a source that has `weight` of a part's `weights`, where the part has
  // `percent` of the budget.
  const auto share = [&](std::size_t percent, std::size_t weight, std::size_t weights) {
    return choice.cases.value_or(
        std::max<std::size_t>(choice.budget * percent * weight / (100 * weights), 1));
  };
  std::vector<TaskSource> sources;
  if (is_chosen("grids")) {
    for (const auto& [side, most] : {std::pair(3, 4), {3, 6}, {4, 4}})
      sources.push_back(grid_source(side, static_cast<std::size_t>(most), share(40, 1, 3)));
  }
  if (is_chosen("corpus")) {
    for (TaskSource& pair : corpus_sources()) sources.push_back(std::move(pair));
  }
  if (is_chosen("families")) {
    // The grids have all degeneracies in the smallest pairs.
    const auto weight = [](const Family& f) -> std::size_t { return f.name == "grid" ? 6 : 1; };
    std::size_t weights = 0;
    for (const Family& family : families()) weights += weight(family);
    for (const Family& family : families())
      sources.push_back(family_source(family, share(30, weight(family), weights), choice.seed, {}));
  }
  for (const std::string part : {"statements", "laws"}) {
    if (!is_chosen(part)) continue;
    std::vector<const Statement*> of_part;
    for (const Statement& statement : statements_on_results())
      if ((statement.kind() == "law") == (part == "laws")) of_part.push_back(&statement);
    for (const Statement* const statement : of_part)
      sources.push_back(statement_source(
          part, *statement, share(part == "laws" ? 20 : 10, 1, of_part.size()), choice.seed));
  }
  return sources;
}

std::vector<TaskSource> conformance_sources(const std::vector<Task>& pairs) {
  std::vector<TaskSource> sources;
  for (const Task& pair : pairs) {
    const auto add = [&](const std::string& by, const Statement* statement) {
      Task task = pair;
      task.statement = statement;
      sources.push_back(
          {"pairs", pair.name + ", by " + by, 1, [task](std::size_t) { return task; }});
    };
    add("the judge", nullptr);
    for (const Statement& statement : statements_on_results()) add(statement.id, &statement);
  }
  return sources;
}

}  // namespace oplus
