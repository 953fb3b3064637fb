// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "properties/runner/record.hpp"

namespace oplus {

/// Adds `properties`; sets exit_code when run.
void add_properties_command(CLI::App& app, int& exit_code);

/// Runs statements, says of each what it did, and how many passed in a last line. Shrunk
/// counterexamples go to the folder `findings`, what each run did, where wanted, to `runs`. Returns
/// whether all passed. cases: none for each statement's own number. With --quiet only failures and the
/// last line are said.
bool run_statements(const std::vector<Statement>& statements, std::optional<std::size_t> cases,
                    std::uint64_t seed, const std::filesystem::path& findings, std::ostream& out,
                    std::vector<PropertyRun>* runs = nullptr);

/// Tries statements on one pair. Returns whether some hold and none fails. What they say goes, where
/// wanted, to `outcomes`.
bool replay_statements(const std::vector<Statement>& statements, const Summands& summands,
                       std::ostream& out, std::vector<Outcome>* outcomes = nullptr);

}  // namespace oplus
