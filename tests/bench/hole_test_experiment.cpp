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

/// Each pair twice: about candidates, the questions of rca; and about edges, a question per edge.
std::vector<Row> rows(const ExperimentSettings& settings) {
  std::vector<Row> all;
  const auto add = [&](const std::string& name, const std::string& family, std::size_t size,
                       const std::function<Summands()>& make) {
    for (const std::string about : {"candidates", "edges"}) {
      Row row{.name = "hole-tests " + name + ", " + about,
              .what = name,
              .subject = Subject::hole_tests,
              .make = [=] { return std::vector<Summands>{make()}; },
              .words = {{"name", name}, {"family", family}, {"about", about}},
              .numbers = {{"size", static_cast<double>(size)}}};
      for (const auto& [method, of] : hole_test_methods()) row.engines.push_back(method);
      all.push_back(std::move(row));
    }
  };
  for (const PublishedPair& pair : published_pairs())
    if (pair.in_thesis && pair.is_there())
      add(pair.name, "published", 0, [=] { return pair.read(); });
  for (const std::size_t m : sizes({25, 200}, settings.scale))
    add("simple " + std::to_string(m), "simple", m, [m, seed = settings.seed] {
      Random random = random_of("hole-tests", seed, m);
      return with_100<simple_polygon, simple_polygon>(random, m);
    });
  for (const std::size_t teeth : sizes({5, 80}, settings.scale))
    add("fork-l " + std::to_string(teeth), "fork", teeth, [=] { return fork_and_l(teeth); });
  return all;
}

/// The methods in the order of this number, the fastest first.
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
  for (const Row& row : rows)
    if (!row.words.at("order").empty())
      ++orders[row.words.at("about") + ": " + row.words.at("order")];
  std::vector<std::string> lines;
  for (const auto& [order, count] : orders)
    lines.push_back("per question about " + order + ", " + std::to_string(count) +
                    (count == 1 ? " pair" : " pairs"));
  return lines;
}

}  // namespace

Experiment hole_test_experiment() {
  return {.name = "hole-tests",
          .what = "The four hole tests on the questions of rca (Section 5.3)",
          .rows = rows,
          .compare = compare,
          .first_columns = {"name", "family", "size", "about", "m", "n", "questions", "asked",
                            "holes", "others", "order", "order_of_all"},
          .summary = summary,
          .plots = {{"hole-tests-simple", "bvh.question", "simple"},
                    {"hole-tests-fork", "bvh.question", "fork"}}};
}

}  // namespace oplus
