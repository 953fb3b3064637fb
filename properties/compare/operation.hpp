// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/compare/campaign_report.hpp"

namespace oplus {

// `diff --operation`: the sums of each engine make the value of an operation (docs/operations.md), which is
// compared with the operation's definition. It is one set, so "closed" and "open" are the same in what is
// judged, and engines are asked for the closed one only.

/// Those of checked/operations/operations.hpp, "complement", and "closed-sum", of regions that may be
/// unbounded.
std::vector<std::string> operation_names();

/// "the definition of ifp"; of sums, the judge's name in words.
std::string judge_in_words(const Campaign& campaign);

/// Rules for sums made into rules for an operation: engines compute it with their sums, its definition
/// (reference/oracle/) judges. Requires: a name of operation_names().
Rules rules_of_operation(const std::string& name, Rules of_sums);

/// Campaign::largest where it is not set.
std::size_t default_largest(const Campaign& campaign);

/// The value as pairs are counted by it: any of "unbounded", "area", "edges" and "points", or "empty".
std::vector<std::string> parts_of_value(const MinkowskiSum& value);

/// Pairs made of those of another source, of all kinds of fitting_pair() in turn.
TaskSource pairs_that_fit(TaskSource source, const std::string& operation);

}  // namespace oplus
