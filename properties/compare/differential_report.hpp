// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "properties/compare/differential.hpp"
#include "properties/compare/shard.hpp"

namespace oplus {

/// Counts of a differential run, by group and in all.
struct Tally {
  std::size_t ran = 0;
  std::size_t skipped = 0;
  std::size_t disagreed = 0;
  std::size_t holes_in_sum = 0;
  std::size_t holes_in_summand = 0;
  std::size_t low_dimensional_features = 0;
  std::size_t overlapping_segments = 0;
  std::size_t several_components = 0;
  Probes probes;
  std::map<std::string, std::size_t> not_taken;  ///< sums, by engine, boundary and reason

  void add(const DifferentialResult& result);
};

/// A disagreement as reported: where it was found and where its shrunk form is.
struct ReportedDisagreement {
  std::size_t index = 0;  ///< of the case
  std::string found_in;   ///< name of the case
  ShrunkDisagreement shrunk;
  std::string p_file;
  std::string q_file;
  std::string picture;
};

struct SkippedCase {
  std::size_t index = 0;
  std::string name;
  std::string why;
};

/// Of a shard; campaign: all that decides what is run, JSON for sealed_report.hpp.
struct DifferentialReport {
  Shard shard;
  nlohmann::json campaign;
  std::uint64_t seed = 0;
  std::vector<std::string> implementations;
  std::string hole_test;  ///< empty: all of them at every probe
  std::map<std::string, Tally> groups;
  Tally all;
  std::vector<SkippedCase> skipped;
  std::vector<ReportedDisagreement> disagreements;
};

/// Files are named without their folder.
nlohmann::ordered_json to_json(const DifferentialReport& report);

/// Returns a table of the groups, the skipped cases and the totals, for people.
std::string summary(const DifferentialReport& report);

/// Writes the shrunk pair as two .dat files and a picture into a folder, which is made if need be.
/// Throws std::system_error.
ReportedDisagreement write_disagreement(const std::string& folder, const std::string& found_in,
                                        const ShrunkDisagreement& shrunk);

/// Returns what the oracle says, what the implementation says, where they differ, and how to see it
/// again.
std::string explanation(const ReportedDisagreement& reported);

}  // namespace oplus
