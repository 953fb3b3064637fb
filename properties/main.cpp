// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>
#include <system_error>

#include "properties/exhaustive/exhaustive_command.hpp"
#include "properties/experiments/experiments_command.hpp"
#include "properties/pages/pages_command.hpp"
#include "properties/runner/diff_command.hpp"
#include "properties/runner/mutants_command.hpp"
#include "properties/runner/properties_command.hpp"
#include "properties/runner/theorems_command.hpp"
#include "reference/io/invalid_input.hpp"

namespace {

int run(int argc, char** argv) {
  int exit_code = 0;
  CLI::App app{"Checks oplus: statements, mutants, and engines against the oracle", "oplus-check"};
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    return std::string("oplus-check: ") + e.what() + '\n';
  });
  app.footer(
      "Example:\n"
      "  oplus-check diff --family grid --cases 500 --seed 7\n\n"
      "Exit codes:\n"
      "  0  all is as it should be\n"
      "  1  a disagreement, a statement that failed, a mutant that lives\n"
      "  2  invalid input or usage, or a file that cannot be read or written\n"
      "  3  a bug in oplus; please report it\n"
      "  4  of experiments: gnuplot is missing or fails; all but the plots is written\n"
      "  5  of exhaustive: interrupted before the end");
  oplus::add_diff_command(app, exit_code);
  oplus::add_exhaustive_command(app, exit_code);
  oplus::add_properties_command(app, exit_code);
  oplus::add_theorems_command(app, exit_code);
  oplus::add_mutants_command(app, exit_code);
  oplus::add_pages_command(app, exit_code);
  oplus::add_experiments_command(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const oplus::InvalidInput& e) {
    std::cerr << "oplus-check: " << e.what() << '\n';
    return 2;
  } catch (const std::system_error& e) {
    std::cerr << "oplus-check: " << e.what() << '\n';
    return 2;
  } catch (const std::exception& e) {
    std::cerr << "oplus-check: a bug in oplus: " << e.what() << "; please report it\n";
    return 3;
  }
}
