// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/campaigns/merged_report.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "properties/compare/conformance/report.hpp"
#include "properties/compare/exhaustive/exhaustive_run.hpp"
#include "properties/compare/sealed_report.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

using Json = nlohmann::ordered_json;
using Reports = std::vector<std::pair<std::string, Json>>;

InvalidInput refused(const std::string& file, const std::string& wrong,
                     const std::string& expected) {
  return {{file, 1, 0}, wrong, expected};
}

std::string short_text(const Json& json) {
  const std::string text = json.dump();
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

/// What differs first between two campaigns, as "seed is 2, not 1".
std::string first_difference(const Json& expected, const Json& found) {
  for (const auto& [key, value] : expected.items()) {
    if (!found.contains(key)) return key + " is not said";
    if (found[key] != value)
      return key + " is " + short_text(found[key]) + ", not " + short_text(value);
  }
  return "more is said";
}

void check_campaign(const std::string& first_file, const Json& first, const std::string& file,
                    const Json& report) {
  for (const char* const key : {"report", "version", "shards"}) {
    if (report[key] != first[key])
      throw refused(file,
                    std::string(key) + " is " + report[key].dump() + ", not " + first[key].dump(),
                    "a shard of the same campaign as " + first_file);
  }
  if (report["campaign"] != first["campaign"])
    throw refused(
        file,
        "it is of another campaign: " + first_difference(first["campaign"], report["campaign"]),
        "a shard of the same campaign as " + first_file);
}

/// One report a shard, in order.
std::vector<Json> all_shards(const Reports& reports) {
  const auto& [first_file, first] = reports.at(0);
  std::map<std::size_t, std::pair<std::string, Json>> by_shard;
  for (const auto& [file, report] : reports) {
    check_campaign(first_file, first, file, report);
    const auto [known, is_new] =
        by_shard.try_emplace(report["shard"].get<std::size_t>(), file, report);
    if (!is_new && known->second.second != report)
      throw refused(file,
                    "shard " + report["shard"].dump() + " is there twice with different content",
                    "that of " + known->second.first);
  }
  const auto count = first["shards"].get<std::size_t>();
  std::string missing;
  std::vector<Json> shards;
  for (std::size_t i = 1; i <= count && missing.size() < 60; ++i) {
    if (by_shard.contains(i))
      shards.push_back(by_shard[i].second);
    else
      missing += (missing.empty() ? "" : ", ") + std::to_string(i);
  }
  if (!missing.empty())
    throw refused(
        first_file,
        "of its campaign's " + std::to_string(count) + " shards these are missing: " + missing,
        "a report of each");
  return shards;
}

/// Adds counts, key by key, at any depth.
void add(nlohmann::json& sum, const nlohmann::json& more) {
  if (more.is_number()) {
    sum = (sum.is_null() ? 0 : sum.get<std::size_t>()) + more.get<std::size_t>();
  } else {
    if (sum.is_null()) sum = nlohmann::json::object();
    for (const auto& [key, value] : more.items()) add(sum[key], value);
  }
}

Json merged_diff(const std::vector<Json>& shards) {
  Json result = shards[0];
  result["shard"] = result["shards"] = 1;
  for (const char* const key : {"all", "groups"}) {
    nlohmann::json sum = nlohmann::json::object();
    for (const Json& shard : shards) add(sum, shard.at(key));
    result[key] = sum;
  }
  for (const char* const key : {"disagreements", "skipped"}) {
    std::vector<Json> all;
    for (const Json& shard : shards)
      all.insert(all.end(), shard.at(key).begin(), shard.at(key).end());
    std::sort(all.begin(), all.end(), [](const Json& a, const Json& b) {
      return a.at("index").get<std::size_t>() < b.at("index").get<std::size_t>();
    });
    result[key] = all;
  }
  // Each shard shrinks its first few, so the campaign's first few are among them.
  const auto most = result["campaign"].at("shrink").get<std::size_t>();
  Json& disagreements = result["disagreements"];
  while (disagreements.size() > most) disagreements.erase(disagreements.size() - 1);
  return result;
}

Json merged_exhaustive(const std::vector<Json>& shards) {
  Json result = shards[0];
  result["shard"] = result["shards"] = 1;
  for (const char* const key : {"pairs", "done", "holes_in_sum", "low_dimensional_features",
                                "overlapping_segments", "disagreed"}) {
    std::size_t sum = 0;
    for (const Json& shard : shards) sum += shard.at(key).get<std::size_t>();
    result[key] = sum;
  }
  SumDigest digest;
  for (const Json& shard : shards) digest.add(SumDigest(shard.at("digest").get<std::string>()));
  result["digest"] = digest.to_string();
  return result;
}

Json merged_conformance(const std::vector<Json>& shards) {
  ConformanceReport result = conformance_of_json(shards[0]);
  result.settings.shard = {};
  for (std::size_t s = 1; s < shards.size(); ++s) {
    const ConformanceReport shard = conformance_of_json(shards[s]);
    for (std::size_t i = 0; i < result.tallies.size(); ++i) result.tallies[i] += shard.tallies[i];
    for (const auto& [kind, found] : shard.counterexamples) {
      const auto [known, is_new] = result.counterexamples.try_emplace(kind, found);
      if (!is_new && is_better(known->second, found)) known->second = found;
    }
  }
  return to_json(result);
}

void check_finished(const Reports& reports) {
  for (const auto& [file, report] : reports) {
    if (report["report"] == "exhaustive" && report.at("done") != report.at("pairs"))
      throw refused(file,
                    "the shard is not finished: " + report["done"].dump() + " of " +
                        report["pairs"].dump() + " pairs",
                    "one that is: run it again with the same --resume");
  }
}

}  // namespace

Json merged_report(const Reports& reports) {
  const std::string first_file = reports.at(0).first;
  try {
    const std::vector<Json> shards = all_shards(reports);
    check_finished(reports);
    const std::string command = shards[0].at("report").get<std::string>();
    if (command == "diff") return merged_diff(shards);
    if (command == "exhaustive") return merged_exhaustive(shards);
    if (command == "conformance") return merged_conformance(shards);
    throw refused(first_file, "a report of " + command, "one of diff, exhaustive or conformance");
  } catch (const nlohmann::json::exception& e) {
    throw refused(first_file, std::string("a report that lacks something: ") + e.what(),
                  "reports that oplus-check wrote");
  }
}

bool found_nothing(const Json& report) {
  if (report.at("report") == "conformance") return report.at("conforms").get<bool>();
  const Json& counts = report["report"] == "diff" ? report.at("all") : report;
  return counts.at("disagreed").get<std::size_t>() == 0;
}

}  // namespace oplus
