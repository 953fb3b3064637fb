// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "properties/compare/differential.hpp"
#include "properties/compare/exhaustive/sum_digest.hpp"

namespace oplus {

/// Which pairs: those of shard `shard` of `shards`, from 1, pair k being of shard k mod shards + 1.
struct Scope {
  int side = 3;
  std::size_t most_vertices = 4;
  std::size_t shard = 1;
  std::size_t shards = 1;

  friend bool operator==(const Scope&, const Scope&) = default;
};

/// How far a run is, and what it saw.
struct ExhaustiveState {
  Scope scope;
  std::vector<std::string> engines;
  std::size_t polygons = 0;
  std::size_t pairs = 0;  ///< of the shard
  std::size_t done = 0;   ///< the first so many of them
  std::size_t holes_in_sum = 0;
  std::size_t low_dimensional_features = 0;
  std::size_t overlapping_segments = 0;
  std::size_t disagreed = 0;
  SumDigest digest;
};

std::string to_json(const ExhaustiveState& state);

/// Throws InvalidInput.
ExhaustiveState state_of_json(const std::string& text, const std::string& file);

/// What a run tells while it goes on.
struct ExhaustiveReports {
  std::function<void(const ExhaustiveState&)> after_some;  ///< now and then, and at the end
  std::function<bool()> is_enough;                         ///< asked as often: stop here?
  std::function<void(const std::string& name, const Summands&, const Disagreement&)> disagreement;
};

/// Goes on from a state, which has a scope, until all its pairs are done or it is enough: each engine
/// against the oracle, closed and open.
ExhaustiveState run_exhaustively(ExhaustiveState state, const std::vector<Engine>& implementations,
                                 unsigned threads, const ExhaustiveReports& reports);

}  // namespace oplus
