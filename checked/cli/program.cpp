// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/program.hpp"

#include "checked/cli/command_line/early_ends.hpp"
#include "checked/cli/command_line/program_frame.hpp"

namespace oplus {

namespace {

const ProgramFrame frame = {
    "oplus", "Compute Minkowski sums of polygons, exactly",
    "Example:\n"
    "  oplus gen tight --n 6 --summand P -o p.wkt\n"
    "  oplus gen tight --n 6 --summand Q -o q.wkt\n"
    "  oplus sum p.wkt q.wkt --open -o sum.wkt --svg sum.svg\n"
    "\n"
    "Exit codes:\n"
    "  0  done; of compare: equal; of verify and certify: it is the sum; of layout: it is right\n"
    "  1  of compare: not equal; of verify and certify: it is not the sum; of layout: it is wrong\n"
    "  2  invalid input or usage, or a file that cannot be read or written\n"
    "  3  a bug in oplus; please report it",
    true};

void add_commands(Program& program) {
  for (const auto add :
       {add_sum, add_compare, add_verify, add_certify, add_operations, add_complement, add_distance,
        add_disc, add_transform, add_layout, add_batch, add_draw, add_reflect, add_repair, add_gen})
    add(program);
}

}  // namespace

int run(int argc, const char* const* argv) noexcept {
  report_crashes();
  return run_program(frame, add_commands, argc, argv);
}

}  // namespace oplus
