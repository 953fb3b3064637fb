// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/conformance/plan.hpp"

#include <algorithm>
#include <memory>

#include "properties/compare/differential_cases.hpp"
#include "properties/compare/exhaustive/grid_polygons.hpp"
#include "properties/runner/property_run.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

namespace {

/// Kept for the life of the program: trials point at them.
const std::vector<Statement>& statements_on_results() {
  static const std::vector<Statement> all = [] {
    std::vector<Statement> kept = statements();
    std::erase_if(kept, [](const Statement& s) { return !s.of_implementation; });
    return kept;
  }();
  return all;
}

struct Grid {
  int side;
  std::size_t most_vertices;
};

constexpr Grid grids[] = {{3, 4}, {3, 6}, {4, 4}};

class Planning {
 public:
  explicit Planning(const ConformanceSettings& settings) : settings_(settings) {}

  ConformancePlan plan() {
    for (const std::string& part : conformance_parts()) {
      const std::vector<std::string>& chosen = settings_.parts;
      if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), part) == chosen.end())
        continue;
      if (part == "grids") add_grids();
      if (part == "corpus") add_corpus();
      if (part == "families") add_families();
      if (part == "statements") add_statements("statements", 10);
      if (part == "laws") add_statements("laws", 20);
    }
    return std::move(plan_);
  }

 private:
  /// How many pairs a group gets that has `weight` of a part's `weights`, the part having so many
  /// percent of the budget.
  std::size_t share(std::size_t percent, std::size_t weight, std::size_t weights) const {
    if (settings_.cases) return *settings_.cases;
    return std::max<std::size_t>(settings_.budget * percent * weight / (100 * weights), 1);
  }

  void begin_group(const std::string& part, const std::string& name) {
    plan_.groups.push_back({part, name});
  }

  Trial& add(const std::string& name, std::function<Summands()> make) {
    ++plan_.groups.back().pairs;
    plan_.trials.push_back({plan_.groups.size() - 1, name, std::move(make)});
    return plan_.trials.back();
  }

  void add_grids() {
    for (const auto& [side, most] : grids) {
      const auto polygons =
          std::make_shared<const std::vector<GridPolygon>>(grid_polygons(side, most));
      const auto orbits = pair_orbits(*polygons);
      const std::size_t wanted = std::min(share(40, 1, std::size(grids)), orbits.size());
      const std::string points = std::to_string(side) + " x " + std::to_string(side) + " points";
      begin_group("grids", points + ", at most " + std::to_string(most) + " vertices, " +
                               std::to_string(wanted) + " of " + std::to_string(orbits.size()) +
                               " pairs");
      for (std::size_t k = 0; k < wanted; ++k) {
        const std::size_t index = k * orbits.size() / wanted;
        const auto [i, j] = orbits[index];
        add("pair " + std::to_string(index) + " of exhaustive --grid " + std::to_string(side) +
                " --vertices " + std::to_string(most),
            [polygons, i = i, j = j] {
              return Summands{region_of((*polygons)[i]), region_of((*polygons)[j])};
            });
      }
    }
  }

  void add_corpus() {
    for (const Row& row : corpus()) {
      begin_group("corpus", row.name);
      add(row.name, [p = row.p, q = row.q] { return Summands{p, q}; }).row = row;
      add(row.name + ", exchanged", [p = row.p, q = row.q] { return Summands{q, p}; }).row = row;
    }
  }

  void add_families() {
    // The grids have all degeneracies in the smallest pairs.
    const auto weight = [](const Family& f) -> std::size_t { return f.name == "grid" ? 6 : 1; };
    std::size_t weights = 0;
    for (const Family& family : families()) weights += weight(family);
    for (const Family& family : families()) {
      begin_group("families", family.name);
      for (DifferentialCase& one : cases_of_family(family, share(30, weight(family), weights),
                                                   settings_.seed, std::nullopt))
        add(one.name, std::move(one.make));
    }
  }

  void add_statements(const std::string& part, std::size_t percent) {
    const auto belongs = [&](const Statement& s) { return (s.kind == "law") == (part == "laws"); };
    const std::vector<Statement>& all = statements_on_results();
    const auto count = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), belongs));
    for (const Statement& statement : all) {
      if (!belongs(statement)) continue;
      begin_group(part, statement.id);
      add_pairs_of(statement, share(percent, 1, count));
    }
  }

  /// Sources in proportion to their weights, each from its smallest size to its largest, and again.
  void add_pairs_of(const Statement& statement, std::size_t count) {
    std::vector<const Source*> in_turn;
    for (const Source& source : statement.sources)
      in_turn.insert(in_turn.end(), static_cast<std::size_t>(source.weight), &source);
    for (std::size_t i = 0; i < count; ++i) {
      const Source& source = *in_turn[i % in_turn.size()];
      const Family& family = *find_family(source.family);
      const std::size_t largest = std::max(source.largest, family.smallest);
      const std::size_t n = family.smallest + i / in_turn.size() % (largest - family.smallest + 1);
      const std::uint64_t seed = seed_of(statement.id, settings_.seed) + i;
      add("gen " + family.name + " --n " + std::to_string(n) + " --seed " + std::to_string(seed),
          [&family, n, seed] { return generate(family, n, seed); })
          .statement = &statement;
    }
  }

  const ConformanceSettings& settings_;
  ConformancePlan plan_;
};

}  // namespace

const std::vector<std::string>& conformance_parts() {
  static const std::vector<std::string> parts = {"grids", "corpus", "families", "statements",
                                                 "laws"};
  return parts;
}

ConformancePlan conformance_plan(const ConformanceSettings& settings) {
  return Planning(settings).plan();
}

ConformancePlan plan_of_pairs(const std::vector<std::pair<std::string, Summands>>& pairs) {
  ConformancePlan plan;
  for (const auto& [name, summands] : pairs) {
    const auto add = [&, made = summands, named = name](const std::string& by,
                                                        const Statement* statement) {
      plan.groups.push_back({"pairs", named + ", by " + by, 1});
      plan.trials.push_back({plan.groups.size() - 1, named, [made] { return made; }});
      plan.trials.back().statement = statement;
    };
    add("the oracle", nullptr);
    for (const Statement& statement : statements_on_results()) add(statement.id, &statement);
  }
  return plan;
}

}  // namespace oplus
