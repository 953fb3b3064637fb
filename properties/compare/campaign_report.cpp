// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/campaign_report.hpp"

#include <algorithm>
#include <tuple>

#include "checked/version.hpp"
#include "properties/compare/operation.hpp"
#include "properties/compare/report_json.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

/// Of one kind the smaller pair is kept, of equal ones that of the earlier task.
bool is_smaller(const ShrunkFailure& a, const ShrunkFailure& b) {
  return std::tie(a.found_size, a.index) < std::tie(b.found_size, b.index);
}

void offer(CampaignReport& report, const std::string& kind, const ShrunkFailure& found) {
  const auto [known, is_new] = report.counterexamples.try_emplace(kind, found);
  if (!is_new && is_smaller(found, known->second)) known->second = found;
}

std::string sealed_without_folder(CampaignReport report) {
  report.out.clear();
  return sealed(report);
}

std::string kind_in(const Campaign& campaign, const WrongSum& wrong) {
  const bool is_only_one = campaign.engines == std::vector{wrong.engine};
  return is_only_one ? wrong.failure.kind : wrong.engine + ": " + wrong.failure.kind;
}

void skip(CampaignReport& report, const std::string& why, const SkippedPairs& more) {
  const auto [known, is_new] = report.skipped.try_emplace(why, more);
  if (is_new) return;
  known->second.times += more.times;
  if (more.index < known->second.index) {
    known->second.index = more.index;
    known->second.first = more.first;
  }
}

/// Of one kind in a source the earlier one is kept.
void keep_first(CountedSource& source, const std::string& kind, const FirstFailure& failure) {
  const auto [known, is_new] = source.first_failures.try_emplace(kind, failure);
  if (!is_new && failure.index < known->second.index) known->second = failure;
}

InvalidInput refused(const std::string& file, const std::string& wrong,
                     const std::string& expected) {
  return {{file, 1, 0}, wrong, expected};
}

}  // namespace

std::size_t Tally::count(const std::string& ruling) const {
  const auto counted = sums.find(ruling);
  return counted == sums.end() ? 0 : counted->second;
}

std::size_t Tally::failures() const {
  std::size_t sum = 0;
  for (const auto& [kind, times] : kinds) sum += times;
  return sum;
}

Tally& Tally::operator+=(const Tally& more) {
  for (const auto count :
       {&Tally::pairs, &Tally::ran, &Tally::skipped, &Tally::disagreed, &Tally::holes_in_sum,
        &Tally::holes_in_summand, &Tally::low_dimensional_features, &Tally::overlapping_segments,
        &Tally::several_components, &Tally::face_probes, &Tally::point_probes})
    this->*count += more.*count;
  for (const auto counts :
       {&Tally::sums, &Tally::values, &Tally::kinds, &Tally::open_unsupported, &Tally::refused})
    for (const auto& [key, count] : more.*counts) (this->*counts)[key] += count;
  return *this;
}

Tally CampaignReport::all() const {
  Tally sum;
  for (const CountedSource& source : sources) sum += source.counts;
  return sum;
}

std::string CampaignReport::interruption() const {
  if (!is_interrupted()) return "";
  if (done == pairs) return "interrupted while shrinking";
  return "interrupted after " + std::to_string(done) + " of " + counted(pairs, "pair", "pairs");
}

std::string CampaignReport::verdict() const {
  const std::string text = !conforms()          ? "does not conform"
                           : compared_nothing() ? "was compared on no pair"
                                                : "conforms";
  return is_interrupted() ? text + ", " + interruption() : text;
}

CampaignReport begun_report(const std::string& command, Campaign campaign, const Shard& shard,
                            const std::vector<TaskSource>& sources) {
  CampaignReport report;
  report.report = command;
  report.version = version;
  report.shard = shard;
  std::size_t tasks = 0;
  for (const TaskSource& source : sources) {
    tasks += source.tasks;
    report.sources.push_back({source.part, source.name});
    campaign.sources.push_back(source.part + ", " + source.name + ": " +
                               std::to_string(source.tasks));
  }
  report.campaign = std::move(campaign);
  report.pairs = shard.count_of(tasks);
  return report;
}

void add(CampaignReport& report, std::size_t source, std::size_t index, const Task& task,
         const JudgedPair& judged) {
  CountedSource& entry = report.sources.at(source);
  Tally& counts = entry.counts;
  bool ran = false, disagreed = false;
  std::string why;
  for (const JudgedSum& sum : judged.sums) {
    ++counts.sums[sum.ruling];
    std::string reason = sum.why;
    if (sum.ruling == name(EngineFailure::Kind::open_unsupported)) {
      ++counts.open_unsupported[sum.engine];
      reason = sum.engine + ": " + sum.why;
    } else if (sum.ruling == name(EngineFailure::Kind::refused)) {
      ++counts.refused[sum.engine + ", " + name(sum.boundary) + ": " + sum.why];
      reason = sum.engine + ": " + sum.why;
    }
    if (why.find(reason) == std::string::npos) why += (why.empty() ? "" : "; ") + reason;
    ran = ran || sum.wrong || sum.ruling == "passed";
    if (!sum.wrong) continue;
    disagreed = true;
    const std::string kind = kind_in(report.campaign, *sum.wrong);
    ++counts.kinds[kind];
    offer(report, kind,
          {*sum.wrong, task.name, entry.part + ", " + entry.name, index, size_of(sum.wrong->pair)});
    keep_first(entry, kind, {index, task.name, sum.wrong->failure.what, sum.wrong->pair});
  }
  if (judged.right) report.digest.add(index, judged.right->closed, judged.right->open);
  ++counts.pairs;
  if (!ran) {
    ++counts.skipped;
    skip(report, why, {1, index, task.name});
    return;
  }
  const Classification& classes = judged.classes;
  ++counts.ran;
  counts.disagreed += disagreed;
  counts.holes_in_summand += classes.holes;
  counts.overlapping_segments += classes.overlapping_segments;
  counts.several_components += classes.several_components;
  counts.face_probes += judged.probes.faces;
  counts.point_probes += judged.probes.points;
  if (!judged.right) return;
  const PlanarSet& open = judged.right->open;
  if (!report.campaign.is_of_sums())
    for (const std::string& part : parts_of_value(open)) ++counts.values[part];
  counts.holes_in_sum += !judged.right->closed.holes.empty();
  counts.low_dimensional_features +=
      !open.dangling_edges.empty() || !open.isolated_vertices.empty();
}

void keep_smallest(CampaignReport& report) {
  auto& all = report.counterexamples;
  while (report.campaign.shrink && all.size() > *report.campaign.shrink)
    all.erase(std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return is_smaller(a.second, b.second);
    }));
}

CampaignReport merged(const std::vector<std::pair<std::string, CampaignReport>>& reports) {
  const auto& [first_file, first] = reports.at(0);
  std::map<std::size_t, const std::pair<std::string, CampaignReport>*> by_shard;
  for (const auto& named : reports) {
    const auto& [file, report] = named;
    if (const std::string wrong = other_campaign(first, report); !wrong.empty())
      throw refused(file, wrong, "a shard of the same campaign as " + first_file);
    if (report.is_interrupted())
      throw refused(file,
                    "the shard was interrupted: " + std::to_string(report.done) + " of " +
                        counted(report.pairs, "pair", "pairs"),
                    "a report of all; run the shard again");
    const auto [known, is_new] = by_shard.try_emplace(report.shard.index, &named);
    if (!is_new && sealed_without_folder(known->second->second) != sealed_without_folder(report))
      throw refused(
          file,
          "shard " + std::to_string(report.shard.index) + " is there twice with different content",
          "that of " + known->second->first);
  }
  std::string missing;
  for (std::size_t i = 1; i <= first.shard.of && missing.size() < 60; ++i)
    if (!by_shard.contains(i)) missing += (missing.empty() ? "" : ", ") + std::to_string(i);
  if (!missing.empty())
    throw refused(first_file,
                  "of its campaign's " + std::to_string(first.shard.of) +
                      " shards these are missing: " + missing,
                  "a report of each");
  CampaignReport result = by_shard.at(1)->second;
  result.shard = {};
  for (const auto& [index, named] : by_shard) {
    if (index == 1) continue;
    const CampaignReport& shard = named->second;
    result.pairs += shard.pairs;
    result.done += shard.done;
    for (std::size_t i = 0; i < result.sources.size(); ++i) {
      result.sources[i].counts += shard.sources.at(i).counts;
      for (const auto& [kind, failure] : shard.sources[i].first_failures)
        keep_first(result.sources[i], kind, failure);
    }
    for (const auto& [why, pairs] : shard.skipped) skip(result, why, pairs);
    for (const auto& [kind, found] : shard.counterexamples) offer(result, kind, found);
    result.digest.add(shard.digest);
  }
  keep_smallest(result);
  return result;
}

}  // namespace oplus
