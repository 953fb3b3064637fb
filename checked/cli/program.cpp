// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/program.hpp"

#include <initializer_list>
#include <string_view>
#include <utility>

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
  for (const auto& [name, add] : std::initializer_list<std::pair<std::string_view, AddCommands>>{
           {"sum", add_sum},
           {"compare", add_compare},
           {"verify", add_verify},
           {"certify", add_certify},
           {"", add_operations},
           {"complement", add_complement},
           {"", add_distance},
           {"disc", add_disc},
           {"transform", add_transform},
           {"layout", add_layout},
           {"batch", add_batch},
           {"draw", add_draw},
           {"reflect", add_reflect},
           {"repair", add_repair},
           {"gen", add_gen}})
    if (name.empty() || program.needs(name)) add(program);
}

}  // namespace

int run(int argc, const char* const* argv) noexcept {
  report_crashes();
  return run_program(frame, add_commands, argc, argv);
}

}  // namespace oplus
