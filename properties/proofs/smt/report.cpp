// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/report.hpp"

#include <cstdio>

#include "properties/runner/registry.hpp"

namespace oplus::smt {

nlohmann::ordered_json to_json(const Query& query) {
  nlohmann::ordered_json hypotheses = nlohmann::ordered_json::object();
  for (const Hypothesis& hypothesis : query.hypotheses)
    hypotheses[hypothesis.name] = hypothesis.condition.says;
  nlohmann::ordered_json of_twins = nlohmann::ordered_json::object();
  for (const Hypothesis& hypothesis : query.hypotheses)
    for (const Condition& condition : hypothesis.of_twin)
      of_twins[hypothesis.name].push_back(condition.says);
  nlohmann::ordered_json in_case = nlohmann::ordered_json::array();
  for (const Condition& condition : query.in_case) in_case.push_back(condition.says);
  return {{"id", query.id},
          {"statement", query.statement()},
          {"file", relative_file(query.file)},
          {"hypotheses", hypotheses},
          {"conclusion", query.conclusion.says},
          {"in_case", in_case},
          {"of_twins", of_twins}};
}

nlohmann::ordered_json to_json(const Model& model) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : model.numbers) json[name] = value.get_str();
  for (const auto& [name, value] : model.flags) json[name] = value;
  return json;
}

Model model_of_json(const nlohmann::ordered_json& json) {
  Model model;
  for (const auto& [name, value] : json.items()) {
    if (value.is_boolean())
      model.flags[name] = value.get<bool>();
    else
      model.numbers[name] = Rational(value.get<std::string>(), 10);
  }
  return model;
}

nlohmann::ordered_json to_json(const Query& query, const QueryRun& run) {
  nlohmann::ordered_json json = to_json(query);
  for (const Asking& asking : run.askings) {
    const auto& [asked, dropped] = asking.question;
    json["answers"][to_string(asking.question)][asking.solver] = to_string(asking.answer.kind);
    nlohmann::ordered_json& found = json["counterexamples"];
    if (asked == Asked::twin && asking.answer.model && !found.contains(dropped))
      found[dropped] = to_json(*asking.answer.model);
  }
  return json;
}

nlohmann::ordered_json record_of(const std::vector<Query>& queries,
                                 const std::vector<QueryRun>& runs) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < runs.size(); ++i) all.push_back(to_json(queries[i], runs[i]));
  return {{"queries", all}};
}

std::string line_of(const QueryRun& run) {
  std::string text = run.id + ":";
  std::string separator = " ";
  for (const Asking& asking : run.askings) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.2f s", asking.seconds);
    text += separator + to_string(asking.question) + " " + to_string(asking.answer.kind) + " (" +
            asking.solver + ", " + seconds + ")";
    separator = ", ";
  }
  return text;
}

}  // namespace oplus::smt
