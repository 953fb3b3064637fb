// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "properties/compare/campaign_report.hpp"

namespace oplus {

/// What a run tells while it goes on, never from two threads at once, and how it is stopped.
struct RunWatch {
  std::function<void()> after_pair = [] {};
  std::function<void(const ShrunkFailure&)> before_shrinking = [](const auto&) {};
  /// If there: asked after every few hundred pairs, with a report to go on from, whether to stop there.
  std::function<bool(const CampaignReport&)> is_enough = {};
};

/// Goes on from a report until all pairs of its shard are done or it is enough: each is judged by the
/// rules, and the counterexamples are shrunk.
/// Requires: the report is of these sources (begun_report()).
CampaignReport run_campaign(CampaignReport report, const std::vector<TaskSource>& sources,
                            const Rules& rules, unsigned threads, const RunWatch& watch = {});

}  // namespace oplus
