// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "properties/compare/conformance/failure_kind.hpp"
#include "properties/compare/corpus.hpp"
#include "properties/runner/statement.hpp"

namespace oplus {

/// A pair, and who says what is right about its sums: the oracle, or a row of the corpus, or a
/// statement that speaks of sums only.
struct Trial {
  std::size_t group = 0;  ///< an index
  std::string name;       ///< says how to make the pair again
  std::function<Summands()> make;
  std::optional<Row> row = {};
  const Statement* statement = nullptr;
};

/// What became of the closed sum or the open one.
enum class Ruling {
  passed,
  wrong,
  crashed,
  hung,
  out_of_memory,
  unreadable,
  not_taken,  ///< the implementation does not take such regions, and says so
  skipped,    ///< too large for the oracle, or the statement says nothing about it
};

/// A failure with all that shows it again. The pair is the trial's own, or, where a statement is
/// broken, that of the first of its sums which the oracle finds wrong.
struct SeenFailure {
  Failure failure;
  Boundary boundary = Boundary::closed;
  Summands summands;
  std::optional<MinkowskiSum> right = {};  ///< none where no oracle was asked
  std::optional<MinkowskiSum> given = {};
};

struct TrialResult {
  Ruling ruling = Ruling::passed;
  std::optional<SeenFailure> seen = {};  ///< where it is none of passed, not_taken and skipped
};

/// Closed, then open.
struct TrialResults {
  TrialResult closed;
  TrialResult open;
};

/// Pairs whose convolution has more than `largest` segments are not given to the oracle: its cost
/// grows with the square of that number.
TrialResults try_out(const Trial& trial, const Engine& implementation, std::size_t largest);

/// What the oracle says of the implementation's sum of one pair.
TrialResult against_oracle(const Summands& summands, Boundary boundary,
                           const Engine& implementation, std::size_t largest);

/// What a statement says of the sums of one pair; where it is broken by a sum that the oracle finds
/// wrong, that is the failure, else its kind is "breaks ID".
TrialResult against_statement(const Summands& summands, Boundary boundary,
                              const Engine& implementation, const Statement& statement,
                              std::size_t largest);

}  // namespace oplus
