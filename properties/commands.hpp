// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/cli/command_line/options.hpp"

namespace oplus {

/// Add the commands of oplus-check, in the order of its help.

/// Compare engines with the oracle or with winding numbers, and merge such reports. Exit codes: 0 all agree; 1 a
/// disagreement; 5 interrupted before the end. Throw InvalidInput, UsageError or std::system_error when run, also
/// where nothing was compared.
void add_diff_command(Program& program);
void add_conformance_command(Program& program);
void add_exhaustive_command(Program& program);
void add_merge_command(Program& program);

void add_properties_command(Program& program);
void add_theorems_command(Program& program);

/// Statements about a few directions, proved by Z3 and by cvc5 (docs/smt.md).
void add_smt_command(Program& program);

/// Add those that oplus-maintain has besides.

/// Exit code 0 where every statement killed its mutants.
void add_mutants_command(Program& program);
void add_fuzz_command(Program& program);

}  // namespace oplus
