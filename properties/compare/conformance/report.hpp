// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "properties/compare/conformance/plan.hpp"
#include "properties/runner/shrinking.hpp"

namespace oplus {

/// Counts of sums, closed and open, but for `pairs`.
struct ConformanceTally {
  std::size_t pairs = 0;
  std::map<Ruling, std::size_t> rulings;
  std::map<std::string, std::size_t> kinds;  ///< of failure

  std::size_t count(Ruling ruling) const;
  std::size_t failures() const;
  ConformanceTally& operator+=(const ConformanceTally& more);
};

/// One of a kind of failure, shrunk.
struct ShrunkFailure {
  SeenFailure seen;
  std::string found_in;       ///< the trial
  std::string group;          ///< its part and its group
  std::size_t index = 0;      ///< of the trial
  Size found_size;            ///< before shrinking; of all of the kind, the smallest one is shrunk
  std::size_t tries = 0;      ///< pairs tried for that
  bool is_shrunk = false;     ///< no pair a step smaller shows it; else the tries were used up
  bool is_repeatable = true;  ///< seen when asked again
};

struct ConformanceReport {
  std::string engine;
  ConformanceSettings settings;
  std::vector<std::string> pairs;                        ///< given ones, instead of settings
  std::vector<TrialGroup> groups;                        ///< of all shards
  std::vector<ConformanceTally> tallies;                 ///< a group each, of this shard
  std::map<std::string, ShrunkFailure> counterexamples;  ///< by kind

  ConformanceTally all() const;
  bool conforms() const { return all().failures() == 0; }
};

/// Whether the second is to be kept instead of the first, both of one kind: the smaller pair, of equal
/// ones the earlier trial.
bool is_better(const ShrunkFailure& first, const ShrunkFailure& second);

/// What all shards know of a campaign before it is run.
nlohmann::ordered_json campaign_of(const ConformanceReport& report);

nlohmann::ordered_json to_json(const ConformanceReport& report);

/// Throws nlohmann::json::exception or InvalidInput where it is none.
ConformanceReport conformance_of_json(const nlohmann::ordered_json& report);

/// For people.
std::string to_markdown(const ConformanceReport& report);

/// For a CI: a suite a part, a case a group.
std::string to_junit(const ConformanceReport& report);

/// The text of a report as the ending of its file says: .md, .xml, else .json.
std::string conformance_text(const ConformanceReport& report, const std::string& file);

/// Whether a file has one of the three endings.
bool is_report_name(const std::string& file);

/// Names of the files of a counterexample, without a folder: they depend on what is in them.
struct CounterexampleFiles {
  std::string p, q, right, given, picture;  ///< empty: there is none
};
CounterexampleFiles files_of(const ShrunkFailure& counterexample);

/// Writes them all into a folder, which is made if need be. Throws std::system_error.
void write_counterexamples(const ConformanceReport& report, const std::string& folder);

/// The line that asks the implementation again.
std::string replay_line(const ConformanceReport& report, const ShrunkFailure& counterexample);

/// "passed", "wrong", ..., in the order of tables.
const std::vector<std::pair<Ruling, std::string>>& rulings();

/// The square root of what SeenFailure has, "about 0.41", for the eye.
std::string distance_in_words(const Rational& squared);

}  // namespace oplus
