// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/arrangement/hole_test.hpp"
#include "reference/families/fork.hpp"
#include "reference/families/polygons.hpp"
#include "tests/bench/experiment.hpp"
#include "tests/bench/families.hpp"
#include "tests/bench/published_pairs.hpp"

namespace oplus {

namespace {

Row named(const std::string& name, const std::string& family, std::size_t size,
          std::function<Summands()> make) {
  Row row;
  row.words = {{"name", name}, {"family", family}};
  row.numbers = {{"size", static_cast<double>(size)}};
  row.subject = Subject::hole_tests;
  row.make = [make = std::move(make)] { return std::vector<Summands>{make()}; };
  for (const auto& [method, of] : hole_test_methods()) row.engines.push_back(method);
  return row;
}

/// Each pair twice: candidates, what rca asks; and edges, a question about each.
std::vector<Row> rows(const ExperimentSettings& settings) {
  std::vector<Row> pairs;
  for (const PublishedPair& pair : published_pairs())
    if (pair.in_thesis && pair.is_there())
      pairs.push_back(named(pair.name, "published", 0, [pair] { return pair.read(); }));
  for (const std::size_t m : doubling_sizes(25, 200, settings.scale))
    pairs.push_back(named("simple " + std::to_string(m), "simple", m, [m, seed = settings.seed] {
      Random random = random_of("hole-tests", seed, m, 1);
      Region p = simple_polygon(random, m);
      return Summands{std::move(p), simple_polygon(random, 100)};
    }));
  for (const std::size_t teeth : doubling_sizes(5, 80, settings.scale))
    pairs.push_back(named("fork-l " + std::to_string(teeth), "fork", teeth,
                          [teeth] { return fork_and_l(teeth); }));
  std::vector<Row> all;
  for (Row& pair : pairs) {
    for (const std::string about : {"candidates", "edges"}) {
      pair.words["about"] = about;
      pair.what = pair.words.at("name");
      pair.name = "hole-tests " + pair.what + ", " + about;
      all.push_back(pair);
    }
  }
  return all;
}

/// The methods by a column of theirs, the fastest first.
std::string order_by(const Row& row, const std::string& column) {
  std::vector<std::pair<double, std::string>> order;
  for (const Measurement& m : row.measurements)
    if (const auto time = row.number(m.engine + '.' + column)) order.emplace_back(*time, m.engine);
  std::sort(order.begin(), order.end());
  std::string names;
  for (const auto& [time, name] : order) names += (names.empty() ? "" : " < ") + name;
  return names;
}

void compare(Row& row) {
  row.words["order"] = order_by(row, "question");
  row.words["order_of_all"] = order_by(row, "all");
}

std::vector<std::string> summary(const Rows& rows) {
  std::map<std::string, std::size_t> orders;
  for (const Row* row : rows)
    if (!row->words.at("order").empty())
      ++orders[row->words.at("about") + ": " + row->words.at("order")];
  std::vector<std::string> lines;
  for (const auto& [order, count] : orders)
    lines.push_back("by a question about " + order + ", " + std::to_string(count) +
                    (count == 1 ? " pair" : " pairs"));
  return lines;
}

}  // namespace

Experiment hole_test_experiment() {
  return {"hole-tests",
          "The four hole tests on what rca asks (Section 5.3)",
          rows,
          compare,
          {"name", "family", "size", "about", "m", "n", "questions", "asked", "holes", "others",
           "order", "order_of_all"},
          summary,
          {{"hole-tests-simple", "bvh.question", "simple"},
           {"hole-tests-fork", "bvh.question", "fork"}}};
}

}  // namespace oplus
