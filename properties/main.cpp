// SPDX-License-Identifier: GPL-3.0-or-later
// Of this file two programs are built: oplus-check and, with OPLUS_MAINTAIN, oplus-maintain, which
// stays in the build folder: it also does what needs the sources.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "checked/cli/command_line/program_frame.hpp"
#include "properties/compare/compare_commands.hpp"
#include "properties/fuzz/fuzz_command.hpp"
#include "properties/pages/pages_commands.hpp"
#include "properties/proofs/smt/smt_command.hpp"
#include "properties/runner/mutants_command.hpp"
#include "properties/runner/properties_command.hpp"

namespace {

#ifdef OPLUS_MAINTAIN
constexpr bool maintain = true;
#else
constexpr bool maintain = false;
#endif

const oplus::ProgramFrame frame = {
    maintain ? "oplus-maintain" : "oplus-check",
    maintain
        ? "All of oplus-check, and what needs the sources of oplus: mutants, pages, records, fuzzing"
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

void remove_option(CLI::App& command, const std::string& option) {
  command.remove_option(command.get_option(option));
}

std::function<int()> add_commands(CLI::App& program) {
  const auto exit_code = std::make_shared<int>(0);
  for (const auto add :
       {oplus::add_diff_command, oplus::add_conformance_command, oplus::add_exhaustive_command,
        oplus::add_merge_command, oplus::add_properties_command, oplus::add_theorems_command,
        oplus::add_smt_command})
    add(program, *exit_code);
  if (maintain) {
    oplus::add_mutants_command(program, *exit_code);
    oplus::add_pages_command(program, *exit_code);
    oplus::add_fuzz_command(program, *exit_code);
  } else {
    remove_option(*program.get_subcommand("properties"), "--record");
    remove_option(*program.get_subcommand("theorems"), "--check");
  }
  return [exit_code] { return *exit_code; };
}

}  // namespace

int main(int argc, char** argv) { return oplus::run_program(frame, add_commands, argc, argv); }
