// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "properties/compare/campaign_report.hpp"

namespace oplus {

/// Callbacks of a run, never called by two threads at once, but for is_interrupted.
struct RunWatch {
  std::function<void()> after_pair = [] {};
  /// Called for each counterexample at the start, before each pair that is tried, and at the end.
  std::function<void(const ShrunkFailure&)> while_shrinking = [](const auto&) {};
  std::function<bool()> is_interrupted = [] { return false; };
  /// If not empty: called after every few hundred pairs, and when interrupted, with a report to go on from.
  std::function<void(const CampaignReport&)> keep = {};
};

/// Goes on from a report until all pairs of its shard are judged by the rules and the counterexamples are
/// shrunk, or it is interrupted: no further pair is begun then, those that engines are working on are
/// waited for, unless they throw std::system_error with the code std::errc::interrupted, and the report is
/// of the pairs before the first that was not judged.
/// Requires: the report is of these sources (begun_report()).
CampaignReport run_campaign(CampaignReport report, const std::vector<TaskSource>& sources,
                            const Rules& rules, unsigned threads, const RunWatch& watch = {});

}  // namespace oplus
