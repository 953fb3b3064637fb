// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "properties/compare/corpus.hpp"
#include "properties/runner/statement.hpp"

namespace oplus {

/// A pair, and what its sums are compared with: the judge, or the corpus, or a statement on sums.
struct Task {
  std::string name;  ///< how to make the pair again
  Summands pair;
  std::shared_ptr<const CorpusPair> known = {};
  const Statement* statement = nullptr;
};

/// Numbered tasks that are counted together: those of a family, of a grid, of a statement, given files.
struct TaskSource {
  std::string part;  ///< sources of a part are counted together, too
  std::string name;
  std::size_t tasks = 0;
  /// Makes one task, so that a run of millions keeps few in memory. Any thread may call it.
  /// Requires: the number is less than `tasks`.
  std::function<Task(std::size_t)> task;
};

}  // namespace oplus
