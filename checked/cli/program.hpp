// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "checked/cli/command_line/options.hpp"

namespace oplus {

/// The program `oplus`. Returns its exit code (exit_code.hpp); writes what went wrong to standard
/// error, in one line. Throws nothing.
int run(int argc, const char* const* argv) noexcept;

/// Add the commands of oplus.
void add_sum(Program& program);
void add_compare(Program& program);
void add_verify(Program& program);
void add_certify(Program& program);
void add_layout(Program& program);
void add_draw(Program& program);
void add_gen(Program& program);
void add_reflect(Program& program);
void add_repair(Program& program);
void add_operations(Program& program);
void add_complement(Program& program);
void add_batch(Program& program);
void add_disc(Program& program);
void add_distance(Program& program);
void add_transform(Program& program);

}  // namespace oplus
