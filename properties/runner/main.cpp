// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "properties/runner/diff_command.hpp"
#include "properties/runner/mutants_command.hpp"
#include "properties/runner/properties_command.hpp"
#include "properties/runner/theorems_command.hpp"

int main(int argc, char** argv) {
  int exit_code = 0;
  try {
    CLI::App app{"Checks oplus: statements, mutants, and engines against the oracle",
                 "oplus-check"};
    app.require_subcommand(1);
    oplus::add_diff_command(app, exit_code);
    oplus::add_properties_command(app, exit_code);
    oplus::add_theorems_command(app, exit_code);
    oplus::add_mutants_command(app, exit_code);
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
      return app.exit(e) == 0 ? 0 : 2;
    }
  } catch (const std::exception& e) {
    std::cerr << "oplus-check: " << e.what() << '\n';
    return 2;
  }
  return exit_code;
}
