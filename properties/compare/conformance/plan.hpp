// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "properties/compare/conformance/trial.hpp"
#include "properties/compare/engine_called.hpp"
#include "properties/compare/shard.hpp"

namespace oplus {

/// What an implementation is asked. Same settings, same trials, on every machine.
struct ConformanceSettings {
  std::uint64_t seed = 1;
  std::size_t budget = 10000;             ///< pairs in all, those of the corpus not counted
  std::optional<std::size_t> cases = {};  ///< pairs a group instead
  std::vector<std::string> parts = {};    ///< of conformance_parts(); none: all of them
  std::size_t largest = 1300;             ///< see try_out()
  std::size_t shrink_tries = 1000;  ///< for one counterexample; a twentieth for one that hangs
  PeerLimits limits = {};           ///< of others' engines
  Shard shard = {};
};

/// "grids": every pair of small polygons on small grids, or an even selection of them; "corpus";
/// "families": random pairs against the oracle; "statements": of the thesis, on results; "laws" of the
/// sum. In the order in which they are run: what finds small pairs comes first.
const std::vector<std::string>& conformance_parts();

/// What is counted together: a grid, a row of the corpus, a family, a statement.
struct TrialGroup {
  std::string part;
  std::string name;
  std::size_t pairs = 0;  ///< of all shards
};

struct ConformancePlan {
  std::vector<TrialGroup> groups;
  std::vector<Trial> trials;  ///< of all shards, in order
};

ConformancePlan conformance_plan(const ConformanceSettings& settings);

/// Given pairs instead, each by the oracle and by every statement: the part "pairs".
ConformancePlan plan_of_pairs(const std::vector<std::pair<std::string, Summands>>& pairs);

}  // namespace oplus
