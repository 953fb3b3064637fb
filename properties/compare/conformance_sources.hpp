// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "properties/compare/task.hpp"

namespace oplus {

/// What an engine is asked. Same choice, same tasks, on every machine.
struct ConformanceChoice {
  std::uint64_t seed = 1;
  std::size_t budget = 10000;             ///< pairs in all, those of the corpus not counted
  std::optional<std::size_t> cases = {};  ///< pairs a source instead
  std::vector<std::string> parts = {};    ///< of conformance_parts(); default: all
};

/// "grids": every pair of small polygons on small grids, or an even selection of them; "corpus";
/// "families": random pairs against the judge; "statements": of the thesis, on results; "laws" of the
/// sum. In the order in which they are run: what finds small pairs comes first.
const std::vector<std::string>& conformance_parts();

std::vector<TaskSource> conformance_sources(const ConformanceChoice& choice);

/// Given pairs instead, each by the judge and by every statement: the part "pairs".
std::vector<TaskSource> conformance_sources(const std::vector<Task>& pairs);

}  // namespace oplus
