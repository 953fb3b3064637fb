// SPDX-License-Identifier: GPL-3.0-or-later
// nlohmann's macros would sort the keys: in version 3.11 they do not support ordered_json.
#include "properties/runner/record.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "checked/cli/json_values.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// The report with its objects in a line each.
std::string one_a_line(const Json& report) {
  std::string text;
  for (const auto& [key, value] : report.items()) {
    text += (text.empty() ? "{" : ",\n") + Json(key).dump() + ": ";
    if (value.empty() || !value.front().is_object()) {
      text += value.dump();
      continue;
    }
    for (const Json& object : value)
      text += (&object == &value.front() ? "[\n" : ",\n") + object.dump();
    text += "\n]";
  }
  return text + "}\n";
}

Json json_of(const Summands& pair) { return {{"p", wkt(pair.p)}, {"q", wkt(pair.q)}}; }

Json json_of(const std::string& statement, const Counterexample& found) {
  Json json = {{"why", found.why}};
  if (found.at) json["at"] = oplus::json(*found.at);
  json.update(json_of(found.summands));
  json["shrinks"] = found.shrinks;
  if (found.files) {
    json["p_file"] = found.files->p;
    json["q_file"] = found.files->q;
    json["replay"] = replay_line(statement, *found.files);
  }
  return json;
}

Json json_of(const PropertyRun& run) {
  Json json = {{"statement", run.statement}, {"title", run.title}, {"passed", run.passed()}};
  if (run.enumeration) json["enumerated"] = run.enumeration->cases;
  json.update({{"run", run.run},
               {"discarded", run.discarded},
               {"families", run.families},
               {"classes", run.classes},
               {"counts", run.counts},
               {"shares_judged", run.shares_judged},
               {"complaints", run.complaints}});
  if (run.counterexample) json["counterexample"] = json_of(run.statement, *run.counterexample);
  if (run.typical) json["typical"] = json_of(*run.typical);
  return json;
}

Json json_of(const Statement& statement, const Outcome& outcome) {
  constexpr const char* words[] = {"holds", "fails", "does not apply"};
  Json json = {{"statement", statement.id},
               {"title", statement.text.title},
               {"outcome", words[static_cast<std::size_t>(outcome.kind)]}};
  if (!outcome.why.empty()) json["why"] = outcome.why;
  json["counts"] = outcome.counts;
  return json;
}

/// The message of a broken contract contains a file, whose path depends on the build, and a line number,
/// which changes with every edit of the file.
std::string without_place(const std::string& why) {
  const std::size_t from = why.starts_with("threw: ") ? 0 : why.find(" broken: ");
  return from == std::string::npos ? why : why.substr(0, why.find(" at ", from));
}

Json json_of(const Kill& kill) {
  Json json = {{"mutant", kill.mutant}, {"statement", kill.statement},
               {"killed", kill.killed}, {"by_enumeration", kill.by_enumeration},
               {"cases", kill.cases},   {"why", without_place(kill.why)}};
  if (kill.at) json["at"] = oplus::json(*kill.at);
  if (kill.shrunk) json["shrunk"] = json_of(*kill.shrunk);
  return json;
}

}  // namespace

std::string to_json(const std::vector<PropertyRun>& runs) {
  Json all = Json::array();
  for (const PropertyRun& run : runs) all.push_back(json_of(run));
  const auto passed =
      std::count_if(runs.begin(), runs.end(), [](const PropertyRun& run) { return run.passed(); });
  return one_a_line({{"statements", all},
                     {"passed", passed},
                     {"failed", static_cast<std::ptrdiff_t>(runs.size()) - passed}});
}

std::string to_json(const std::vector<Statement>& statements,
                    const std::vector<Outcome>& outcomes) {
  Json all = Json::array();
  std::size_t numbers[3] = {};
  for (std::size_t i = 0; i < statements.size(); ++i) {
    all.push_back(json_of(statements[i], outcomes[i]));
    ++numbers[static_cast<std::size_t>(outcomes[i].kind)];
  }
  return one_a_line({{"statements", all},
                     {"passed", numbers[0]},
                     {"failed", numbers[1]},
                     {"not_applicable", numbers[2]}});
}

std::string to_json(const std::vector<Kill>& kills) {
  Json all = Json::array();
  for (const Kill& kill : kills) all.push_back(json_of(kill));
  const auto killed =
      std::count_if(kills.begin(), kills.end(), [](const Kill& kill) { return kill.killed; });
  return one_a_line({{"kills", all},
                     {"killed", killed},
                     {"not_killed", static_cast<std::ptrdiff_t>(kills.size()) - killed}});
}

}  // namespace oplus
