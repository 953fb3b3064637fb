// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "properties/compare/corpus.hpp"
#include "properties/runner/statement.hpp"

namespace oplus {

/// A pair, and who says what is right about its sums: the oracle, or the corpus, or a statement that
/// speaks of sums only.
struct Task {
  std::string name;  ///< says how to make the pair again
  Summands pair;
  std::shared_ptr<const CorpusPair> known = {};
  const Statement* statement = nullptr;
};

/// Numbered tasks that are counted together: those of a family, of a grid, of a statement, given files.
struct TaskSource {
  std::string part;  ///< what sources are counted together further on
  std::string name;
  std::size_t tasks = 0;
  /// Makes one task, so that a run of millions holds few at a time. Any thread may call it.
  /// Requires: the number is less than `tasks`.
  std::function<Task(std::size_t)> task;
};

}  // namespace oplus
