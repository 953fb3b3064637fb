// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/compare/campaign_report.hpp"

namespace oplus {

// `diff --operation`: the sums of each engine make the value of an operation (docs/operations.md), which is
// compared with the operation's definition. It is one set, so "closed" and "open" are the same in what is
// judged, and engines are asked for the closed one only.

/// Those of checked/operations/operations.hpp, and of regions that may be unbounded:
///  1. "complement", and "union", as `--union` makes it, of all components of P and Q;
///  2. "closed-sum";
///  3. "path-sum" and "sum-of-paths": closed sums of the path and points that path_and_points() makes of P with Q,
///     and with the path of Q;
///  4. "rounded-sum": closed-sum, which is also rounded to a grid, to each side; a rounding that breaks a promise
///     (grid_promises.hpp) is a failure.
std::vector<std::string> compared_operations();

/// "the definition of ifp"; of sums, the judge's name in words.
std::string judge_in_words(const Campaign& campaign);

/// Rules for sums made into rules for an operation: engines compute it with their sums, its definition
/// (reference/oracle/) judges. Requires: a name of compared_operations().
Rules rules_of_operation(const std::string& name, Rules of_sums);

/// Campaign::largest where it is not set.
std::size_t default_largest(const Campaign& campaign);

/// The value as pairs are counted by it: any of "unbounded", "area", "edges" and "points", or "empty".
std::vector<std::string> parts_of_value(const PlanarSet& value);

/// Pairs made of those of another source, of all kinds of fitting_pair() in turn.
TaskSource pairs_that_fit(TaskSource source, const std::string& operation);

}  // namespace oplus
