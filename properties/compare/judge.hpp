// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "checked/engine.hpp"
#include "properties/compare/failure_kind.hpp"
#include "properties/compare/task.hpp"
#include "properties/runner/classification.hpp"

namespace oplus {

/// Both sums of a pair, as a judge has them.
struct RightSums {
  PlanarSet closed;
  PlanarSet open;

  const PlanarSet& of(Boundary boundary) const {
    return boundary == Boundary::closed ? closed : open;
  }
};

/// Computes the sums that those of engines are compared with, closed and open, without their code.
struct Judge {
  std::string name;
  std::string in_words;
  std::size_t largest;  ///< the default of Rules::largest
  std::function<RightSums(const Region& p, const Region& q)> sums;
};

/// The oracle (oracle.hpp), which is the default, and "convex-parts" (sum_by_convex_parts.hpp).
const std::vector<Judge>& judges();

/// Throws std::invalid_argument where there is none of that name.
const Judge& judge_named(const std::string& name);

/// The outcomes for a closed or an open sum, in the order of tables: "passed", "wrong"; without a sum the
/// name of EngineFailure's kind, of which "open unsupported" and "refused" are no faults; "skipped": it is too large
/// for the judge, or the statement does not apply.
const std::vector<std::string>& rulings();

/// A sum that is wrong or missing, with all that reproduces it. The pair is the task's own, or, where a
/// statement is broken, that of the first of its sums which the judge finds wrong.
struct WrongSum {
  std::string engine;  ///< the judge's name where that threw
  Boundary boundary = Boundary::closed;
  Failure failure;
  Summands pair;
  std::optional<PlanarSet> right = {};  ///< nullopt where the judge was not asked
  std::optional<PlanarSet> given = {};
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
  Probes probes;                        ///< of all engines
  std::optional<RightSums> right = {};  ///< where the judge or the corpus was asked
};

/// Which engines are asked for which sums, and who judges.
struct Rules {
  std::vector<Engine> engines;
  std::vector<Boundary> boundaries = {Boundary::closed, Boundary::open};
  /// Pairs whose convolution has more segments are not given to the judge: its cost grows with the
  /// square of that number and more.
  std::size_t largest = static_cast<std::size_t>(-1);
  /// Whether engines are asked about such pairs nevertheless: they may crash.
  bool asks_beyond = false;
  Judge judge = judges().front();
};

/// Asks each engine for each sum of a task's pair and judges the answers. Where a statement is broken
/// by a sum that the judge finds wrong, that is the failure, else its kind is "breaks ID". An exception
/// other than EngineFailure is a crash, its message without digits the site. Throws std::system_error where an
/// engine does: it could not be asked, or was interrupted.
JudgedPair judged(const Task& task, const Rules& rules);

}  // namespace oplus
