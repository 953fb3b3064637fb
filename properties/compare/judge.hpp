// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "checked/engine.hpp"
#include "properties/compare/failure_kind.hpp"
#include "properties/compare/task.hpp"
#include "properties/runner/classification.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

/// The outcomes for a closed or an open sum, in the order of tables: "passed", "wrong"; without a sum the
/// name of NoSum's kind, of which "open unsupported" and "refused" are no faults; "skipped": it is too large
/// for the oracle, or the statement does not apply.
const std::vector<std::string>& rulings();

/// A sum that is wrong or missing, with all that reproduces it. The pair is the task's own, or, where a
/// statement is broken, that of the first of its sums which the oracle finds wrong.
struct WrongSum {
  std::string engine;  ///< "oracle" where that threw
  Boundary boundary = Boundary::closed;
  Failure failure;
  Summands pair;
  std::optional<MinkowskiSum> right = {};  ///< nullopt where the oracle was not asked
  std::optional<MinkowskiSum> given = {};
};

struct JudgedSum {
  std::string engine;
  Boundary boundary = Boundary::closed;
  std::string ruling = "passed";
  std::string why = {};                ///< it is refused, unsupported or skipped
  std::optional<WrongSum> wrong = {};  ///< where it is a fault
};

/// How often hole tests were asked.
struct Probes {
  std::size_t faces = 0;
  std::size_t points = 0;
};

struct JudgedPair {
  std::vector<JudgedSum> sums;
  Classification classes;
  Probes probes;                         ///< of all engines
  std::optional<OracleSums> right = {};  ///< where the oracle or the corpus was asked
};

/// Which engines are asked for which sums.
struct Rules {
  std::vector<Engine> engines;
  std::vector<Boundary> boundaries = {Boundary::closed, Boundary::open};
  /// Pairs whose convolution has more segments are not given to the oracle: its cost grows with the
  /// square of that number.
  std::size_t largest = static_cast<std::size_t>(-1);
  /// Whether engines are asked about such pairs nevertheless: they may crash.
  bool asks_beyond = false;
};

/// Asks each engine for each sum of a task's pair and judges the answers. Where a statement is broken
/// by a sum that the oracle finds wrong, that is the failure, else its kind is "breaks ID". An exception
/// other than NoSum is a crash, its message without digits the site. Throws std::system_error where an
/// engine does: it could not be asked, or was interrupted.
JudgedPair judged(const Task& task, const Rules& rules);

}  // namespace oplus
