// SPDX-License-Identifier: GPL-3.0-or-later
// Of this file three programs are built: oplus-check and two that stay in the build folder: with
// OPLUS_MAINTAIN oplus-maintain, which also does what needs the sources, and with OPLUS_COMPARE
// oplus-compare, which is what properties/run builds: the comparison without the statements.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "checked/cli/command_line/program_frame.hpp"
#include "properties/compare/compare_commands.hpp"
#ifndef OPLUS_COMPARE
#include "properties/fuzz/fuzz_command.hpp"
#include "properties/pages/pages_commands.hpp"
#include "properties/proofs/smt/smt_command.hpp"
#include "properties/runner/mutants_command.hpp"
#include "properties/runner/properties_command.hpp"
#endif

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

const oplus::ProgramFrame frame = {
    name,
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
#ifdef OPLUS_COMPARE
  oplus::add_diff_command(program, *exit_code);
#else
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
#endif
  return [exit_code] { return *exit_code; };
}

}  // namespace

int main(int argc, char** argv) { return oplus::run_program(frame, add_commands, argc, argv); }
