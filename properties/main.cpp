// SPDX-License-Identifier: GPL-3.0-or-later
// Of this file three programs are built: oplus-check and two that stay in the build folder: with
// OPLUS_MAINTAIN oplus-maintain, which also does what needs the sources, and with OPLUS_COMPARE
// oplus-compare, which is what properties/run builds: the comparison without the statements.

#include "checked/cli/command_line/program_frame.hpp"
#include "properties/commands.hpp"

namespace oplus {

namespace {

#ifdef OPLUS_MAINTAIN
constexpr bool maintain = true;
#else
constexpr bool maintain = false;
#endif
#ifdef OPLUS_COMPARE
constexpr const char* name = "oplus-compare";
#else
constexpr const char* name = maintain ? "oplus-maintain" : "oplus-check";
#endif

const ProgramFrame frame = {
    name,
    maintain ? "All of oplus-check, and what needs the sources of oplus: mutants, records, fuzzing"
             : "Check oplus: the statements, and the engines against the oracle",
    "Example:\n"
    "  oplus-check diff --family grid --cases 500 --seed 7\n"
    "  oplus-check properties --theorem lemma-4.1.4\n"
    "  oplus-check theorems lemma-4.1.4\n"
    "\n"
    "Exit codes:\n"
    "  0  success\n"
    "  1  a disagreement, a statement that failed; of oplus-maintain: a mutant that survives\n"
    "  2  invalid input or usage, or a file that cannot be read or written\n"
    "  3  a bug in oplus; please report it\n"
    "  5  of diff, exhaustive and conformance: interrupted before the end"};

void add_commands(Program& program) {
#ifdef OPLUS_COMPARE
  add_diff_command(program);
#else
  for (const auto add :
       {add_diff_command, add_conformance_command, add_exhaustive_command, add_merge_command,
        add_properties_command, add_theorems_command, add_smt_command})
    add(program);
  if (maintain) {
    for (const auto add : {add_mutants_command, add_fuzz_command}) add(program);
  } else {
    program.command("properties").remove("--record");
  }
#endif
}

}  // namespace

}  // namespace oplus

int main(int argc, char** argv) {
  return oplus::run_program(oplus::frame, oplus::add_commands, argc, argv);
}
