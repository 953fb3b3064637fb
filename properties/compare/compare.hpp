// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "checked/cli/command_line/options.hpp"
#include "properties/compare/campaign_report.hpp"

namespace oplus {

/// The options of every command that compares; the campaign's engines as named on the command line.
struct CompareOptions {
  Campaign campaign;
  std::optional<std::size_t> largest;           ///< default: the judge's
  std::vector<std::vector<std::string>> pairs;  ///< of files
  std::string shard = "1/1";
  unsigned threads = 0;  ///< 0: one per core
  std::string out = "oplus-findings";
  std::vector<std::string> reports;
  std::string resume;
  bool json = false;
};

/// Add options; the target must live as long as the command.
void add_run_options(const Command& command, CompareOptions& options);
Option add_engine_option(const Command& command, CompareOptions& options, const std::string& what);
void add_limit_options(const Command& command, CompareOptions& options);
void add_shrink_option(const Command& command, Campaign& campaign);
void add_pair_option(const Command& command, CompareOptions& options);

/// Reads the pairs of files and notes their names. Throws InvalidInput.
std::vector<Task> given_pairs(CompareOptions& options);

/// Compares: runs the shard, writes the counterexamples, the reports and the text. Returns the exit code,
/// see compare_commands.hpp. Only `conformance` asks engines for sums that are too large for the judge.
int compare(const std::string& command, CompareOptions options,
            const std::vector<TaskSource>& sources);

}  // namespace oplus
