// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <string>
#include <system_error>

#include "checked/cli/command_line/program_frame.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "checked/cli/usage_error.hpp"
#include "properties/compare/campaigns/merge_command.hpp"
#include "properties/compare/conformance/conformance_command.hpp"
#include "properties/compare/diff_command.hpp"
#include "properties/compare/exhaustive/exhaustive_command.hpp"
#include "properties/fuzz/fuzz_command.hpp"
#include "properties/pages/pages_command.hpp"
#include "properties/pages/theorems_command.hpp"
#include "properties/proofs/smt/smt_command.hpp"
#include "properties/runner/mutants_command.hpp"
#include "properties/runner/properties_command.hpp"
#include "reference/io/invalid_input.hpp"

namespace {

constexpr int exit_invalid = 2;
constexpr int exit_bug = 3;
const std::string name = "oplus-check";

int run(int argc, char** argv) {
  int exit_code = 0;
  CLI::App app{"Check oplus: the statements, the mutants, and the engines against the oracle",
               name};
  oplus::set_up(app);
  app.footer(
      "Example:\n"
      "  oplus-check diff --family grid --cases 500 --seed 7\n"
      "  oplus-check properties --theorem lemma-4.1.4\n"
      "  oplus-check theorems lemma-4.1.4\n"
      "\n"
      "Exit codes:\n"
      "  0  all is as it should be\n"
      "  1  a disagreement, a statement that failed, a mutant that lives\n"
      "  2  invalid input or usage, or a file that cannot be read or written\n"
      "  3  a bug in oplus; please report it\n"
      "  5  of exhaustive: interrupted before the end");
  oplus::add_diff_command(app, exit_code);
  oplus::add_conformance_command(app, exit_code);
  oplus::add_exhaustive_command(app, exit_code);
  oplus::add_merge_command(app, exit_code);
  oplus::add_properties_command(app, exit_code);
  oplus::add_theorems_command(app, exit_code);
  oplus::add_mutants_command(app, exit_code);
  oplus::add_pages_command(app, exit_code);
  oplus::add_fuzz_command(app, exit_code);
  oplus::add_smt_command(app, exit_code);
  const oplus::Choose choose = [&exit_code](const std::function<void()>& work) {
    work();
    exit_code = 0;
  };
  oplus::add_completion_command(app, choose);
  oplus::add_man_command(app, choose);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    app.exit(asked);
  } catch (const CLI::ParseError& error) {
    throw oplus::UsageError(oplus::complaint(app, error));
  }
  // Results that nobody received are no success.
  if (!std::cout.flush()) throw oplus::UsageError("cannot write standard output");
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  oplus::occupy_closed_streams();
  // A reader that closes its pipe is an output that cannot be written, not a death.
  // Handled, not ignored: the programs that it starts would ignore it, too.
  std::signal(SIGPIPE, [](int) {});
  try {
    return run(argc, argv);
  } catch (const oplus::InvalidInput& e) {
    oplus::say_error(name, e.what());
    return exit_invalid;
  } catch (const oplus::UsageError& e) {
    oplus::say_error(name, e.what());
    return exit_invalid;
  } catch (const std::system_error& e) {
    oplus::say_error(name, e.what());
    return exit_invalid;
  } catch (const std::exception& e) {
    oplus::say_error(name, std::string("a bug in oplus: ") + e.what() + "; please report it");
    return exit_bug;
  }
}
