// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mutants_command.hpp"

#include <algorithm>
#include <iostream>
#include <memory>

#include "properties/runner/property_run.hpp"

namespace oplus {

namespace {

struct Settings {
  std::optional<std::size_t> cases;
  std::uint64_t seed = 1;
};

/// Whether an enumeration that fails with the fault holds without.
bool killed_by_enumeration(const Statement& statement, const Enumeration& with, std::ostream& out) {
  const Enumeration without = enumerated(statement);
  if (without.failure.empty())
    out << "killed by the enumeration: " << with.failure << '\n' << std::flush;
  else
    out << "NOT KILLED: the enumeration fails without the fault too: " << without.failure << '\n'
        << std::flush;
  return without.failure.empty();
}

/// Whether the statement kills the mutant: its enumeration fails with the fault and holds without,
/// or it fails on a pair with the fault and holds on the same pair without. A run that is short or
/// misses a share kills nothing.
bool kills(const Statement& statement, const Mutant& mutant, RunOptions options,
           std::ostream& out) {
  options.shrink = false;
  options.mutant = mutant.name;
  const PropertyRun run = run_property(statement, options);
  out << "  " << statement.id << ": ";
  if (run.enumeration && !run.enumeration->failure.empty())
    return killed_by_enumeration(statement, *run.enumeration, out);
  if (!run.counterexample) {
    out << "ALIVE after " << run.run << " cases\n" << std::flush;
    return false;
  }
  const Outcome without = evaluate(statement, run.counterexample->summands);
  if (without.kind != Outcome::Kind::holds) {
    out << "NOT KILLED: case " << run.run << " fails without the fault too: " << without.why << '\n'
        << std::flush;
    return false;
  }
  out << "killed by case " << run.run << ": " << run.counterexample->why << '\n' << std::flush;
  return true;
}

bool names(const Statement& statement, const std::string& mutant) {
  return std::find(statement.kills.begin(), statement.kills.end(), mutant) != statement.kills.end();
}

}  // namespace

bool run_mutants(const std::vector<Statement>& statements, const std::vector<Mutant>& mutants,
                 std::optional<std::size_t> cases, std::uint64_t seed, std::ostream& out) {
  std::size_t killed = 0, alive = 0;
  for (const Mutant& mutant : mutants) {
    out << mutant.name << ": " << mutant.what << '\n';
    for (const Statement& statement : statements) {
      if (!names(statement, mutant.name)) continue;
      RunOptions options;
      options.cases = cases.value_or(statement.cases);
      options.seed = seed;
      ++(kills(statement, mutant, options, out) ? killed : alive);
    }
  }
  const std::vector<std::string> defects = defects_of_entries(statements, mutants);
  for (const std::string& defect : defects) out << defect << '\n';
  out << killed << " killed, " << alive << " not killed\n";
  return alive == 0 && killed > 0 && defects.empty();
}

void add_mutants_command(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("mutants", "Switch on faults one by one and see statements fail");
  const auto settings = std::make_shared<Settings>();
  command
      ->add_option("--cases", settings->cases,
                   "Cases after which a mutant is called alive; default: the statement's number")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000000}));
  command->add_option("--seed", settings->seed, "Same seed, same pairs")->capture_default_str();
  command->footer("Example: build/check/bin/oplus-check mutants");
  command->callback([settings, &exit_code] {
#ifdef OPLUS_MUTANTS
    const bool all_died =
        run_mutants(statements(), mutants(), settings->cases, settings->seed, std::cout);
    exit_code = all_died ? 0 : 1;
#else
    std::cerr << "oplus-check mutants: this build contains no mutants; use the preset `check`: "
                 "build/check/bin/oplus-check mutants\n";
    exit_code = 2;
#endif
  });
}

}  // namespace oplus
