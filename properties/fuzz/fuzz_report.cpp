// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_report.hpp"
#include "reference/io/counted.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

namespace oplus {

namespace {

/// What follows the last `key`, to the end of the line.
std::optional<std::string_view> after_last(std::string_view log, std::string_view key) {
  const std::size_t at = log.rfind(key);
  if (at == std::string_view::npos) return std::nullopt;
  log.remove_prefix(at + key.size());
  return log.substr(0, log.find('\n'));
}

std::size_t number_after_last(std::string_view log, std::string_view key) {
  std::size_t number = 0;
  if (auto rest = after_last(log, key)) {
    rest->remove_prefix(std::min(rest->find_first_not_of(' '), rest->size()));
    std::from_chars(rest->data(), rest->data() + rest->size(), number);
  }
  return number;
}

/// The first that says what is wrong; oplus's own words before a sanitizer's.
std::string finding_in(std::string_view log) {
  for (const char* key : {"oplus: finding: ", "runtime error: ", "ERROR: AddressSanitizer: ",
                          "ERROR: LeakSanitizer: ", "ERROR: libFuzzer: ", "ERROR: "})
    if (const auto found = after_last(log, key)) return std::string(*found);
  return {};
}

}  // namespace

FuzzReport report_of(const std::string& target, std::string_view log, bool ended_well) {
  FuzzReport report;
  report.target = target;
  report.runs = number_after_last(log, "stat::number_of_executed_units:");
  report.edges = number_after_last(log, " cov:");
  report.reached = number_after_last(log, "oplus: reached ");
  report.rejected = number_after_last(log, ", rejected ");
  if (ended_well) return report;
  // libFuzzer also writes slow ones, which are no finding.
  if (const auto input = after_last(log, "Test unit written to ")) report.input = *input;
  report.finding = finding_in(log);
  if (report.finding.empty()) report.finding = "the program did not run to its end";
  return report;
}

std::string line_of(const FuzzReport& report) {
  std::string line = report.target;
  line.resize(std::max<std::size_t>(line.size(), 8), ' ');
  line += ' ' + counted(report.runs, "run", "runs") + ", " + counted(report.edges, "edge", "edges");
  if (report.finding.empty())
    return line + ", " + counted(report.reached, "input", "inputs") + " reached, " +
           std::to_string(report.rejected) + " rejected; no finding";
  line += "; finding: " + report.finding;
  if (!report.input.empty()) line += "; input: " + report.input;
  return line;
}

nlohmann::json to_json(const FuzzReport& report) {
  nlohmann::json json{{"target", report.target}, {"runs", report.runs}, {"edges", report.edges}};
  if (report.finding.empty()) {
    json["reached"] = report.reached;
    json["rejected"] = report.rejected;
  }
  if (!report.finding.empty()) json["finding"] = report.finding;
  if (!report.input.empty()) json["input"] = report.input;
  return json;
}

}  // namespace oplus
