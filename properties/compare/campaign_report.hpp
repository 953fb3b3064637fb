// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "checked/cli/shard.hpp"
#include "properties/compare/judge.hpp"
#include "properties/compare/sum_digest.hpp"
#include "properties/runner/shrinking.hpp"

namespace oplus {

/// All options that decide what is asked and what is reported: the same for all shards.
struct Campaign {
  std::vector<std::string> engines;
  std::string hole_test = "all";
  std::string judge = judges().front().name;
  std::string operation = "sum";  ///< what is made of each pair
  std::uint64_t seed = 1;
  std::optional<std::size_t> n = {};  ///< largest size of generated pairs; default: the family's
  std::size_t largest = judges().front().largest;  ///< see Rules
  std::optional<std::size_t> shrink = {};  ///< the most counterexamples to keep; default: unlimited
  std::size_t shrink_tries = 5000;         ///< per counterexample; a twentieth for one that hangs
  double time_limit = 10;                  ///< of programs and peers, in seconds
  std::size_t memory_limit = 4000;         ///< likewise, in MB; 0: unlimited
  std::vector<std::string> pairs = {};     ///< given ones, by name
  std::vector<std::string> sources = {};   ///< a line per source

  /// Whether closed and open sums are compared, not one value of an operation (operation.hpp).
  bool is_of_sums() const { return operation == "sum"; }
};

/// Counts of pairs, and below of their sums, closed and open, by each engine.
struct Tally {
  std::size_t pairs = 0;
  std::size_t ran = 0;      ///< an engine's sum was judged
  std::size_t skipped = 0;  ///< none was
  std::size_t disagreed = 0;
  std::size_t holes_in_sum = 0;
  std::size_t holes_in_summand = 0;
  std::size_t low_dimensional_features = 0;  ///< of the open sum
  std::size_t overlapping_segments = 0;      ///< of the reduced convolution
  std::size_t several_components = 0;
  std::size_t face_probes = 0;  ///< how often hole tests were asked
  std::size_t point_probes = 0;
  std::map<std::string, std::size_t> sums;              ///< by ruling
  std::map<std::string, std::size_t> values;            ///< of an operation: parts_of_value()
  std::map<std::string, std::size_t> kinds;             ///< of failure, as `counterexamples` below
  std::map<std::string, std::size_t> open_unsupported;  ///< by engine
  std::map<std::string, std::size_t> refused;           ///< by engine, boundary and reason

  std::size_t count(const std::string& ruling) const;
  std::size_t failures() const;
  Tally& operator+=(const Tally& more);
};

/// A kind's smallest pair that was found, shrunk.
struct ShrunkFailure {
  WrongSum sum;
  std::string found_in;       ///< the task's name
  std::string source;         ///< its part and its name
  std::size_t index = 0;      ///< of the task
  Size found_size = {};       ///< before shrinking
  std::size_t tries = 0;      ///< pairs tried for that
  bool is_shrunk = false;     ///< no pair a step smaller fails in this way; else it was not tried
  bool is_repeatable = true;  ///< it failed again in this way when asked again
};

/// Pairs that were skipped for one reason.
struct SkippedPairs {
  std::size_t times = 0;
  std::size_t index = 0;  ///< of the first task
  std::string first;      ///< its name
};

/// The first pair of a source that failed in some way.
struct FirstFailure {
  std::size_t index = 0;  ///< of the task
  std::string found_in;   ///< its name
  std::string what;       ///< see Failure
  Summands pair;
};

struct CountedSource {
  std::string part;
  std::string name;
  Tally counts = {};
  std::map<std::string, FirstFailure> first_failures = {};  ///< by kind
};

/// What a command that compares engines has found, or one shard of it. It contains no times and no names
/// of machines: same campaign, same answers of the engines, same folder, same report, however many threads.
struct CampaignReport {
  std::string report;   ///< the command
  std::string version;  ///< of oplus
  Campaign campaign;
  Shard shard;
  std::size_t pairs = 0;               ///< of the shard
  std::size_t done = 0;                ///< the first of them were judged
  bool has_stopped_shrinking = false;  ///< interrupted before all counterexamples were shrunk
  std::string out;  ///< the folder of the counterexamples' files, as it was given
  std::vector<CountedSource> sources;
  std::map<std::string, SkippedPairs> skipped;  ///< by reason
  std::map<std::string, ShrunkFailure>
      counterexamples;  ///< by kind, of several engines also by name
  SumDigest digest;     ///< of the judge's sums

  Tally all() const;
  bool conforms() const { return all().disagreed == 0; }
  bool compared_nothing() const { return all().ran == 0; }
  bool is_interrupted() const { return done < pairs || has_stopped_shrinking; }
  /// "interrupted after 12 of 40 pairs", "interrupted while shrinking"; empty where it is not.
  std::string interruption() const;

  /// "conforms", "does not conform" or "was compared on no pair"; where it is interrupted, with that.
  std::string verdict() const;
};

/// A report before the first pair.
CampaignReport begun_report(const std::string& command, Campaign campaign, const Shard& shard,
                            const std::vector<TaskSource>& sources);

/// Adds the outcome of a task, of which only the name and the pair are looked at.
void add(CampaignReport& report, std::size_t source, std::size_t index, const Task& task,
         const JudgedPair& judged);

/// Removes all but the campaign's number of counterexamples: those found with the smallest pairs stay, so
/// that the ones of a campaign are among those of its shards.
void keep_smallest(CampaignReport& report);

/// Returns the report that one run without shards would have written, of the reports of all shards of
/// one campaign, each with the name of its file; a shard may be there more than once with the same
/// content. Throws InvalidInput where shards are missing, one is there twice with different content or
/// is interrupted, or they are not of one campaign, command and version. The folder is the first shard's.
CampaignReport merged(const std::vector<std::pair<std::string, CampaignReport>>& reports);

}  // namespace oplus
