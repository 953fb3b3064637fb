// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "properties/runner/record.hpp"

namespace oplus {

/// Runs statements, prints a report of each, and how many passed in a last line. Shrunk counterexamples
/// are written to the folder `findings`; each run is appended to `runs` unless that is null. Returns whether
/// all passed. `cases`: by default each statement's own number. With --quiet only failures and the last line
/// are printed.
bool run_statements(const std::vector<Statement>& statements, std::optional<std::size_t> cases,
                    std::uint64_t seed, const std::filesystem::path& findings, std::ostream& out,
                    std::vector<PropertyRun>* runs = nullptr);

/// Tries statements on one pair. Returns whether some hold and none fails. Outcomes are appended to
/// `outcomes` unless that is null.
bool replay_statements(const std::vector<Statement>& statements, const Summands& summands,
                       std::ostream& out, std::vector<Outcome>* outcomes = nullptr);

}  // namespace oplus
