// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

#include "properties/mutants/mutants.hpp"
#include "properties/runner/record.hpp"
#include "properties/runner/registry.hpp"

namespace oplus {

/// Runs each statement against each mutant it names and prints after how many cases it was killed. Appends
/// to `kills` unless that is null. Returns whether all were killed, and there was one.
/// Requires: a build with OPLUS_MUTANTS.
bool run_mutants(const std::vector<Statement>& statements, const std::vector<Mutant>& mutants,
                 std::optional<std::size_t> cases, std::uint64_t seed, std::ostream& out,
                 std::vector<Kill>* kills = nullptr);

}  // namespace oplus
