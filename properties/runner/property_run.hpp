// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "properties/runner/finding.hpp"
#include "properties/runner/statement.hpp"

namespace oplus {

struct RunOptions {
  std::size_t cases = 100;  ///< that must hold, discarded ones not counted
  std::uint64_t seed = 1;
  bool shrink = true;
  /// Switched on while a pair is checked and while cases are enumerated, never while a pair is
  /// made; or empty.
  std::string mutant = {};
};

struct Counterexample {
  /// No smaller pair (see `smaller`) fails; with a mutant, fails with the fault and holds without.
  Summands summands;
  std::string why;
  std::size_t shrinks;                ///< how many steps it took
  std::optional<Finding> files = {};  ///< where it was written, if it was
  std::optional<Point> at = {};       ///< as `Outcome::at`
};

/// What a run did. It has passed only if `complaints` is empty.
struct PropertyRun {
  std::string statement;  ///< its id
  std::string title = {};
  std::optional<Enumeration> enumeration = {};  ///< where the statement has one
  std::size_t run = 0;                          ///< cases that held or failed
  std::size_t discarded = 0;
  std::map<std::string, std::size_t> classes = {};   ///< how many of `run`, by class; absent: none
  std::map<std::string, std::size_t> families = {};  ///< the same by family
  std::map<std::string, std::size_t> counts = {};    ///< as the statement counts
  std::vector<std::string> complaints = {};
  std::optional<Counterexample> counterexample = {};
  std::optional<Summands> typical = {};  ///< of the cases that held, one of middle size
  bool shares_judged = false;            ///< whether there were enough cases for that

  bool passed() const { return complaints.empty(); }
};

/// Whether a promise is of a count of the outcomes instead of a class of pairs: "cases with ...", to which each
/// outcome adds 1 or nothing.
inline bool is_of_a_count(const Promise& promise) {
  return promise.classification.starts_with("cases with ");
}

/// Below this number of cases a missed share says nothing, so shares are reported, not judged.
constexpr std::size_t cases_to_judge_shares = 50;

/// Goes through the statement's enumeration; unless that fails, tries the statement on pairs from
/// its sources, with RapidCheck. A failing case of the enumeration is a complaint, and so is an empty
/// enumeration. Of the pairs, everything that is not "as many cases as asked, all hold, every promised
/// share kept" is a complaint: a failure, zero cases, fewer cases than asked, too many discarded, a
/// generator that throws. Same options, same run, on every compiler; nothing in the environment
/// changes it.
PropertyRun run_property(const Statement& statement, const RunOptions& options);

}  // namespace oplus
