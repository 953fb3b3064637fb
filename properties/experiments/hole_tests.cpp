// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/hole_test.hpp"

#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "properties/experiments/growing_families.hpp"
#include "properties/experiments/hole_test_questions.hpp"
#include "properties/experiments/plot.hpp"
#include "properties/experiments/process_of_its_own.hpp"
#include "properties/experiments/published_pairs.hpp"
#include "properties/experiments/repetitions.hpp"
#include "reference/families/fork.hpp"
#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

/// More are thinned out evenly: the slowest method takes milliseconds for each.
constexpr std::size_t most_questions = 100;
constexpr std::size_t rounds = 3;

/// The two sets of questions, by what the column `about` says.
struct Questions {
  std::string about;
  std::vector<Segment> (*of)(const Summands& pair);
};
const std::vector<Questions> all_questions = {{"candidates", questions_of_rca},
                                              {"edges", questions_about_edges}};

struct NamedPair {
  std::string name;
  std::string family;
  std::size_t size;
  std::function<Summands()> make;
};

std::vector<NamedPair> pairs_to_ask_about(const ExperimentSettings& settings) {
  std::vector<NamedPair> pairs;
  for (const PublishedPair& pair : published_pairs())
    if (is_there(pair)) pairs.push_back({pair.name, "published", 0, [pair] { return read(pair); }});
  for (const std::size_t m : doubling_sizes(25, 200, settings.scale))
    pairs.push_back({"simple " + std::to_string(m), "simple", m, [m, seed = settings.seed] {
                       Random random = random_of("hole-tests", seed, m, 1);
                       Region p = simple_polygon(random, m);
                       return Summands{std::move(p), simple_polygon(random, 100)};
                     }});
  for (const std::size_t teeth : doubling_sizes(5, 80, settings.scale))
    pairs.push_back(
        {"fork-l " + std::to_string(teeth), "fork", teeth, [teeth] { return fork_and_l(teeth); }});
  return pairs;
}

/// One round of questions.
struct Asked {
  Seconds preparing{};
  Seconds of_holes{};  ///< of the questions whose answer is that it is a hole
  Seconds of_others{};
  std::string answers;  ///< h and s, hole and sum
};

Asked ask(const HoleTestMethod& method, const Summands& pair,
          const std::vector<Segment>& questions) {
  Asked asked;
  const std::unique_ptr<HoleTest> test =
      timed(asked.preparing, [&] { return method(pair.p, pair.q); });
  for (const Segment& question : questions) {
    Seconds one{};
    const bool is_hole = timed(one, [&] { return test->is_hole_right_of(question); });
    (is_hole ? asked.of_holes : asked.of_others) += one;
    asked.answers += is_hole ? 'h' : 's';
  }
  return asked;
}

/// What a process reports of one method.
Row measured(const HoleTestMethod& method, const Summands& pair,
             const std::vector<Segment>& all_of_them) {
  const std::vector<Segment> questions = thinned_out(all_of_them, most_questions);
  std::vector<Asked> all;
  while (all.size() < rounds) all.push_back(ask(method, pair, questions));
  const Asked asked = median(std::move(all), [](const Asked& round) {
    return (round.preparing + round.of_holes + round.of_others).count();
  });
  const auto holes =
      static_cast<std::size_t>(std::count(asked.answers.begin(), asked.answers.end(), 'h'));
  const std::size_t others = questions.size() - holes;
  Row row = {{"m", vertex_count(pair.p)},
             {"n", vertex_count(pair.q)},
             {"questions", all_of_them.size()},
             {"asked", questions.size()},
             {"holes", holes},
             {"others", others},
             {"prepare", asked.preparing.count()},
             {"answers", asked.answers}};
  if (holes > 0) row["hole"] = asked.of_holes.count() / static_cast<double>(holes);
  if (others > 0) row["other"] = asked.of_others.count() / static_cast<double>(others);
  if (!questions.empty()) {
    const double mean =
        (asked.of_holes + asked.of_others).count() / static_cast<double>(questions.size());
    row["question"] = mean;
    row["all"] = asked.preparing.count() + mean * static_cast<double>(all_of_them.size());
  }
  return row;
}

const std::vector<std::string> of_pair = {"m", "n", "questions", "asked", "holes", "others"};
const std::vector<std::string> of_method = {"prepare", "hole", "other", "question", "all"};

/// The methods by a column of theirs, the fastest first.
std::string order_by(const Row& row, const std::string& column) {
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, method] : hole_test_methods())
    if (const std::optional<double> time = number(row, name + '_' + column))
      order.emplace_back(*time, name);
  std::sort(order.begin(), order.end());
  std::string names;
  for (const auto& [time, name] : order) names += (names.empty() ? "" : " < ") + name;
  return names;
}

Row row_of(const NamedPair& pair, const Questions& questions, const ExperimentSettings& settings,
           std::vector<std::string>& wrong) {
  Row row = {{"name", pair.name},
             {"family", pair.family},
             {"size", pair.size},
             {"about", questions.about}};
  std::optional<std::string> answers;
  for (const auto& [name, method] : hole_test_methods()) {
    const auto work = [&, method = method] {
      const Summands made = pair.make();
      return measured(method, made, questions.of(made)).dump();
    };
    const ProcessReport report = in_process_of_its_own(work, settings.memory_limit_mb);
    const bool done = report.kind == ProcessReport::Kind::done;
    row[name + "_outcome"] = done ? "done" : report.text;
    if (report.kind == ProcessReport::Kind::failed)
      wrong.push_back(pair.name + ": " + name + ' ' + report.text);
    if (!done) continue;
    const Row found = Row::parse(report.text);
    for (const std::string& column : of_pair) row[column] = found.at(column);
    for (const std::string& column : of_method)
      if (found.contains(column)) row[name + '_' + column] = found.at(column);
    const std::string own = found.at("answers");
    if (answers && *answers != own)
      wrong.push_back(pair.name + ": " + name + " answers differently");
    answers = own;
  }
  row["order"] = order_by(row, "question");
  row["order_of_all"] = order_by(row, "all");
  return row;
}

std::vector<ShownTable> shown_tables() {
  std::vector<ShownTable> shown = {
      {"Candidates: what rca asks, about faces. Edges: one question each about the edges of its "
       "arrangement. Which method is faster: by a question, then by preparing and all questions.",
       {{"pair", "name"},
        {"m", "m"},
        {"n", "n"},
        {"about", "about"},
        {"questions", "questions"},
        {"asked here", "asked"},
        {"holes", "holes"},
        {"others", "others"},
        {"by a question", "order"},
        {"with preparing", "order_of_all"}}}};
  std::vector<ShownColumn> times = {{"pair", "name"}, {"about", "about"}};
  for (const auto& [name, method] : hole_test_methods()) {
    times.push_back({name + ": prepare", name + "_prepare", 1e6});
    times.push_back({"hole", name + "_hole", 1e6});
    times.push_back({"other", name + "_other", 1e6});
  }
  shown.push_back({"Microseconds to prepare, and for a question, by its answer.", times});
  return shown;
}

std::optional<Plot> plot(const Table& table, const std::string& family, const std::string& size) {
  Table of_family{table.columns, {}};
  for (const Row& row : table.rows)
    if (row.at("family") == family && row.at("about") == "candidates")
      of_family.rows.push_back(row);
  std::vector<Series> series;
  const std::vector<std::pair<std::string, std::string>> coloured = {
      {"bvh", "#0072b2"}, {"sweep", "#d55e00"}, {"naive", "#999999"}, {"ray", "#009e73"}};
  const std::string only =
      "strcol(\"family\") eq \"" + family + "\" && strcol(\"about\") eq \"candidates\"";
  for (const auto& [name, colour] : coloured)
    series.push_back({name + "_question", name, colour, std::nullopt, only});
  return plot_of("hole-tests-" + family, "hole-tests.csv", of_family,
                 {"Hole tests, " + family, "size", size, "microseconds a question", true, 1e6},
                 series);
}

}  // namespace

ExperimentResult run_hole_tests(const ExperimentSettings& settings) {
  ExperimentResult result;
  result.title = "Hole tests";
  result.table.columns = {"name", "family", "size", "about"};
  std::vector<std::string>& columns = result.table.columns;
  columns.insert(columns.end(), of_pair.begin(), of_pair.end());
  columns.insert(columns.end(), {"order", "order_of_all"});
  for (const auto& [name, method] : hole_test_methods()) {
    columns.push_back(name + "_outcome");
    for (const std::string& column : of_method) columns.push_back(name + '_' + column);
  }
  std::map<std::string, std::size_t> orders;
  for (const NamedPair& pair : pairs_to_ask_about(settings)) {
    for (const Questions& questions : all_questions) {
      Row row = row_of(pair, questions, settings, result.wrong);
      const std::string order = row.at("order");
      std::cout << "hole-tests " << pair.name << ", " << questions.about << ": "
                << (order.empty() ? "no question" : order) << std::endl;
      if (!order.empty()) ++orders[questions.about + ": " + order];
      result.table.rows.push_back(std::move(row));
    }
  }
  result.shown = shown_tables();
  for (const auto& [order, count] : orders)
    result.summary.push_back("by a question about " + order + ", " + std::to_string(count) +
                             (count == 1 ? " pair" : " pairs"));
  add(result.plots, plot(result.table, "simple", "vertices of P"));
  add(result.plots, plot(result.table, "fork", "teeth an arm"));
  return result;
}

}  // namespace oplus
